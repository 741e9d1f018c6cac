// Every input of the corpus through its target, with whatever compiler and flags the tests are built: seeds,
// and inputs that once ended a fuzzer ("regression-…"). A target that finds a fault ends this process.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "targets.h"

namespace barrido::fuzz {

/// In the tests' names.
void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

std::vector<std::filesystem::path> inputs_of(const Target& target) {
  const std::filesystem::path folder =
      std::filesystem::path(BARRIDO_SOURCE_DIR) / "tests/fuzz/corpus" / target.name;
  std::vector<std::filesystem::path> inputs;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) inputs.push_back(entry.path());
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, EveryInputEndsWell) {
  const std::vector<std::filesystem::path> inputs = inputs_of(GetParam());
  EXPECT_FALSE(inputs.empty());
  for (const std::filesystem::path& path : inputs) {
    std::cout << path.string() << std::endl;  // the last one named is the one that ended the process
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    GetParam().run({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, testing::ValuesIn(kTargets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace barrido::fuzz
