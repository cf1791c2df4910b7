#pragma once

#include <span>
#include <variant>

#include "measures/measures.h"
#include "store/store.h"

namespace runout {

// The members of the result structs by the names they have in db/schema.sql and in JSON. Writing, reading and
// reporting go through these lists; the lists of Measures is measure_fields().

/// One column of RunWork.
struct WorkColumn {
    const char* name;
    std::variant<long RunWork::*, int RunWork::*, double RunWork::*> member;
};
std::span<const WorkColumn> work_columns();

/// One column of a table whose values are all real numbers.
template <class Row>
struct RealColumn {
    const char* name;
    double Row::*value;
};
std::span<const RealColumn<SeriesRow>> series_columns();
std::span<const RealColumn<DepositRow>> deposit_columns();
std::span<const RealColumn<StageRow>> stage_columns();
std::span<const RealColumn<PlaceRecord>> place_columns();
std::span<const RealColumn<BarrierRecord>> barrier_columns();
std::span<const RealColumn<FrameScale>> frame_scale_columns();
std::span<const RealColumn<PilotRow>> pilot_columns();
std::span<const RealColumn<Appraisal>> appraisal_numbers();

/// One word or sentence of an appraisal.
struct AppraisalText {
    const char* name;
    std::string Appraisal::*value;
};
std::span<const AppraisalText> appraisal_texts();

/// One array of a snapshot.
struct SnapshotColumn {
    const char* name;
    std::vector<float> Snapshot::*value;
};
std::span<const SnapshotColumn> snapshot_columns();

}  // namespace runout
