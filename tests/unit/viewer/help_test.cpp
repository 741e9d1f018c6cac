// The help says everything, in lines that fit.
#include "viewer/barrido/help.h"

#include <gtest/gtest.h>

#include "viewer/barrido/render_options.h"
#include "viewer/barrido/values.h"

namespace barrido::cli {
namespace {

TEST(Help, LinesFitIntoAHundredColumns) {
  for (const std::string& text : {general_help(), render_help(), inspect_help(), info_help(), diff_help()}) {
    for (const std::string_view line : split(text, '\n')) {
      EXPECT_LE(line.size(), 99u) << line;
      EXPECT_TRUE(line.empty() || line.back() != ' ') << line;
    }
    EXPECT_EQ(text.back(), '\n');
  }
}

TEST(Help, NamesEveryOptionOnceAtTheBeginningOfALine) {
  const std::string text = render_help();
  for (const OptionSyntax& option : render_syntax()) {
    const std::string entry =
        (option.short_name.empty() ? "\n      " : "\n  " + std::string(option.short_name) + ", ") +
        std::string(option.name);
    const std::size_t found = text.find(entry + (option.form.empty() ? " " : ""));
    EXPECT_NE(found, std::string::npos) << option.name;
  }
}

TEST(Help, SectionsStandInOrder) {
  const std::string text = render_help();
  std::size_t place = 0;
  for (const char* section : {"Output:", "Shading:", "Textures:", "Lights:", "Camera:", "Animation:",
                              "Colour:", "Execution:", "Examples:"}) {
    const std::size_t found = text.find(std::string("\n") + section + "\n", place);
    ASSERT_NE(found, std::string::npos) << section;
    place = found;
  }
}

TEST(Help, LongTextsAreBrokenUnderTheirColumn) {
  const OptionSyntax syntax[] = {{"A", "--x", "-x", OptionKind::optional_value, "N",
                                  "aaaaaaaaaaaaaaaaaaaa bbbbbbbbbbbbbbbbbbbbbbbbbbbbbb "
                                  "cccccccccccccccccccccccccccccc ddddddddddddddddddd"}};
  EXPECT_EQ(options_help(syntax),
            "\nA:\n  -x, --x[=N]  aaaaaaaaaaaaaaaaaaaa bbbbbbbbbbbbbbbbbbbbbbbbbbbbbb "
            "cccccccccccccccccccccccccccccc\n               ddddddddddddddddddd\n");
}

TEST(Help, VersionIsOneLine) { EXPECT_EQ(version_text().substr(0, 8), "barrido "); }

}  // namespace
}  // namespace barrido::cli
