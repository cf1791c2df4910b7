#include "accuracy/study.h"

#include <algorithm>
#include <cmath>

namespace runout {
namespace {

bool is_choice(const LadderRun& entry) {
    return entry.series == choice_series || entry.series == ladder_choice_series;
}

ChoiceCheck check_of(const LadderRun& entry, const Reference& reference, const Store& store) {
    ChoiceCheck check{entry.setting, store.run(entry.run_id), entry.resolution, 0, false};
    check.off_finest_m = check.run.measures.run_out_m - reference.run_out_m;
    check.inside =
        is_result(check.run.status) && std::abs(check.off_finest_m) <= check.run.appraisal.run_out_error_m;
    return check;
}

}  // namespace

AccuracyStudy read_study(const StoredLadder& stored, const Store& store) {
    AccuracyStudy study;
    study.name = stored.name;
    study.machine = stored.machine;
    study.ladder = read_ladder(stored, store);
    study.prices = price_list(study.ladder);
    StoredLadder methods = stored;
    std::erase_if(methods.runs, is_choice);
    study.points = read_methods(methods, study.ladder, store);
    const Reference reference = reference_of(study.ladder);
    for (const LadderRun& entry : stored.runs)
        if (is_choice(entry)) study.choices.push_back(check_of(entry, reference, store));
    return study;
}

std::vector<AccuracyStudy> read_studies(const Store& store) {
    std::vector<StoredLadder> latest;
    for (StoredLadder& ladder : store.ladders()) {
        const auto same = std::ranges::find(latest, ladder.question_hash, &StoredLadder::question_hash);
        if (same == latest.end())
            latest.push_back(std::move(ladder));
        else
            *same = std::move(ladder);
    }
    std::vector<AccuracyStudy> studies;
    for (const StoredLadder& ladder : latest) studies.push_back(read_study(ladder, store));
    return studies;
}

}  // namespace runout
