#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "profile/section_file.h"
#include "temporary_folder.h"

namespace runout {

/// Files in a directory of their own, removed afterwards.
class SectionFiles : public testing::Test {
  protected:
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }

  private:
    TemporaryFolder folder_;
};

}  // namespace runout
