#pragma once

// What most tests need: GoogleTest, the names of its matchers, files, texts and lists.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace ar3d::testing {

namespace fs = std::filesystem;

using ::testing::AllOf, ::testing::AnyOf, ::testing::Contains, ::testing::ContainsRegex;
using ::testing::Each, ::testing::ElementsAre, ::testing::EndsWith, ::testing::HasSubstr;
using ::testing::IsEmpty, ::testing::MatchesRegex, ::testing::Not, ::testing::SizeIs;
using ::testing::StartsWith;

}  // namespace ar3d::testing
