// Every row of the options has all its facts: what is written is read again, the default is that of the
// renderer and of the help, and the window has an editor or a reason.
#include "viewer/barrido/render_option_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "viewer/barrido/settings_file.h"
#include "viewer/barrido/text_format.h"

namespace barrido::cli {
namespace {

using Texts = std::vector<std::string>;

/// Values that the row takes: all words, numbers at random and at the bounds, examples of what has a form of
/// its own.
class RandomValues {
 public:
  Texts of(const RenderOption& row) {
    if (row.value.kind == OptionKind::flag) return {""};
    if (!row.value.names.empty()) return words(row);
    if (row.value.is_number) return numbers(row);
    return of_form(row.syntax.form, row.value.range);
  }

 private:
  double share() { return std::ldexp(static_cast<double>(engine_()), -32); }

  double between(Range range) {
    // Beyond, three of them would be no longer than the table's texts, but no test of the small ones.
    const double least = std::max(range.least, -1e4), most = std::min(range.most, 1e4);
    return static_cast<double>(static_cast<float>(least + (most - least) * share()));
  }

  static Texts words(const RenderOption& row) { return {row.value.names.begin(), row.value.names.end()}; }

  Texts numbers(const RenderOption& row) {
    const Range& range = row.value.range;
    if (row.value.is_whole) {
      return {std::to_string(std::lround(range.least)), std::to_string(std::lround(range.most)),
              std::to_string(std::lround(range.least + share() * (range.most - range.least)))};
    }
    return {shortest_double(range.least), shortest_double(between(range)), shortest_double(between(range))};
  }

  std::string vector(Range range) {
    return shortest(glm::vec3(between(range), between(range), between(range)));
  }

  Texts of_form(std::string_view form, Range range) {
    if (form == "X,Y,Z" || form == "R,G,B") return {vector(range), vector(range), vector(range)};
    if (form == "R,G,B[,A]") return {vector({0, 1}), vector({0, 1}) + ",0.25", "environment"};
    if (form == "AXIS") return {"+Z", "-X", vector({}), vector({})};
    if (form == "W,H") return {"1,16384", "320,200"};
    if (form == "OPEN,CLOSE") return {"0,0.5", "-1.25,2"};
    if (form == "X,Y") return {"0,3", "16383,16383"};
    if (form == "NAME[:radius=R]") return {"gaussian", "box:radius=" + shortest_double(between({0.6, 8}))};
    if (form == "A:B") return {"0:0", "3:999999"};
    if (form == "LIST") return {"1,7,3", "2"};
    if (form == "OUT" || form == "FILE" || form == "PATH") return {"a folder/it's $here", "dynamic"};
    if (form.starts_with("PATH[:")) {
      return {"a folder/it's $here", "b.png:repeat=" + shortest_double(between({1, 9})) + ",-0.5",
              "c.png:height=" + shortest_double(between({-1, 1})) + ":form=blinn"};
    }
    if (form == "text|json") return {"text", "json"};
    if (form == "NAME") return {"midnight", "it's $here", "2"};
    if (form == "SET") return {"auto", "scalar"};
    if (form == "SIZE") return {"16M", "1.5G", "123456789K"};
    if (form == "SPEC") {
      return {"roughness=" + shortest_double(between({0, 1})) + ":diffuse=" + vector({0, 2}),
              "exp:" + shortest_double(between({0, 1})),
              "linear:" + shortest_double(between({})) + ",20000:" + vector({0, 1}),
              "point:color=" + vector({0, 2}) + ":pos=" + vector({}) + ":range=3",
              "spot:cutoff=12.3:space=camera",
              "marble:scale=" + shortest_double(between({1e-3, 10})) + ":dark=" + vector({0, 1}),
              "a folder/it's $here.png",
              "sphere:from=normal:size=" + shortest_double(between({1e-3, 10}))};
    }
    return {};
  }

  std::mt19937 engine_{7};
};

/// Options that hold `text`; none where the row refuses it.
std::optional<RenderOptions> read(const RenderOption& row, const std::string& text) {
  RenderOptions options;
  try {
    row.read(options, text);
  } catch (const ValueError&) {
    return std::nullopt;
  }
  return options;
}

TEST(RenderOptionTable, WhatIsWrittenIsReadAgain) {
  RandomValues random;
  for (const RenderOption& row : render_option_table()) {
    ASSERT_NE(row.value.read, nullptr) << row.syntax.name;
    ASSERT_NE(row.value.write, nullptr) << row.syntax.name;
    int read_back = 0;
    bool differs = false;
    for (int round = 0; round < 50; ++round) {
      for (const std::string& text : random.of(row)) {
        const std::optional<RenderOptions> options = read(row, text);
        if (!options) continue;
        const Texts written = row.value.write(*options);
        ASSERT_EQ(written.size(), 1u) << row.syntax.name << " " << text;
        const std::optional<RenderOptions> again = read(row, written[0]);
        ASSERT_TRUE(again) << row.syntax.name << " " << written[0];
        EXPECT_EQ(row.value.write(*again), written) << row.syntax.name << " " << text;
        ++read_back;
        differs |= row.is_given(*options);
      }
    }
    EXPECT_GT(read_back, 40) << row.syntax.name << ": the test has no values for its form";
    EXPECT_TRUE(differs) << row.syntax.name << ": reading it changes nothing that it writes";
  }
}

/// What one row reads no other row writes; a copied row with a field forgotten would.
TEST(RenderOptionTable, EachRowHasItsOwnField) {
  RandomValues random;
  for (const RenderOption& row : render_option_table()) {
    for (const std::string& text : random.of(row)) {
      const std::optional<RenderOptions> options = read(row, text);
      if (!options) continue;
      for (const RenderOption& other : render_option_table()) {
        if (&other == &row) continue;
        EXPECT_FALSE(other.is_given(*options))
            << row.syntax.name << " " << text << " sets " << other.syntax.name;
      }
    }
  }
}

TEST(RenderOptionTable, NumbersStopAtTheirBounds) {
  for (const RenderOption& row : render_option_table()) {
    if (!row.value.is_number) continue;
    const double step = row.value.is_whole ? 1.0 : 1e-3 * std::max(1.0, std::abs(row.value.range.most));
    EXPECT_TRUE(read(row, shortest_double(row.value.range.least))) << row.syntax.name;
    EXPECT_FALSE(read(row, shortest_double(row.value.range.least - step))) << row.syntax.name;
    EXPECT_FALSE(read(row, shortest_double(row.value.range.most + step))) << row.syntax.name;
  }
}

/// Words and numbers that have a default say so in the help, and it is the one that the options begin with.
TEST(RenderOptionTable, HelpNamesTheDefaultOfTheRenderer) {
  const RenderOptions defaults;
  int checked = 0;
  for (const RenderOption& row : render_option_table()) {
    const Texts texts = row.value.write(defaults);
    const bool has_default =
        !texts.empty() &&
        (!row.value.names.empty() || row.syntax.name == "--resolution" ||
         row.syntax.name == "--compression" || row.syntax.name == "--fps" || row.syntax.name == "--exposure");
    if (!has_default || row.syntax.name == "--view") continue;  // Of views the default is to have none.
    const std::string help(row.syntax.help), text = texts[0];
    const std::size_t in_parentheses = help.find(text + " (");
    const bool marked =
        in_parentheses != std::string::npos &&
        help.substr(in_parentheses, help.find(')', in_parentheses) - in_parentheses).ends_with("default");
    EXPECT_TRUE(marked || help.find("efault " + text) != std::string::npos) << row.syntax.name << " " << text;
    ++checked;
  }
  EXPECT_GE(checked, 12);
}

TEST(RenderOptionTable, HelpNamesEveryWord) {
  for (const RenderOption& row : render_option_table()) {
    for (const std::string_view word : row.value.names) {
      const bool on_or_off = row.syntax.form == "on|off";
      EXPECT_TRUE(on_or_off || row.syntax.help.find(word) != std::string_view::npos)
          << row.syntax.name << " takes " << word;
    }
  }
}

TEST(RenderOptionTable, SettingsHaveAnEditorOrAReason) {
  using Kind = Editor::Kind;
  for (const RenderOption& row : render_option_table()) {
    const Editor& editor = row.editor;
    EXPECT_EQ(editor.kind == Kind::missing, !row.syntax.is_setting()) << row.syntax.name;
    if (editor.kind == Kind::missing) continue;
    EXPECT_EQ(editor.label.empty(), editor.kind == Kind::special) << row.syntax.name;
    EXPECT_FALSE(editor.kind == Kind::special && editor.heading.empty()) << row.syntax.name;
    if (editor.kind != Kind::widget) continue;
    const bool is_flag = row.value.kind == OptionKind::flag;
    EXPECT_TRUE(is_flag || row.value.is_number || !row.value.names.empty()) << row.syntax.name;
    EXPECT_NE(row.value.clear, nullptr) << row.syntax.name;
    EXPECT_EQ(row.value.names.size(), row.value.titles.size()) << row.syntax.name;
    EXPECT_EQ(editor.without.empty(), row.value.names.empty() || !row.value.is_optional) << row.syntax.name;
    if (!row.value.is_number) continue;
    EXPECT_LT(editor.slider.least, editor.slider.most) << row.syntax.name;
    EXPECT_GE(editor.slider.least, row.value.range.least) << row.syntax.name;
    EXPECT_LE(editor.slider.most, row.value.range.most) << row.syntax.name;
  }
}

/// A key or a click goes through all that the option can be, and comes back.
TEST(RenderOptionTable, StepsGoRound) {
  for (const RenderOption& row : render_option_table()) {
    if (row.editor.kind != Editor::Kind::widget) continue;
    RenderOptions options;
    if (row.value.is_number) {
      row.set_number(options, row.value.range.most + 1e9);
      EXPECT_EQ(row.number(options), row.value.range.most) << row.syntax.name;
      step_option(options, row.syntax.name, 1.0f);
      EXPECT_EQ(row.number(options), row.value.range.most) << row.syntax.name;
      continue;
    }
    const std::size_t count = row.value.names.empty() ? 2 : row.value.names.size() + row.value.is_optional;
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(row.is_given(options), i > 0) << row.syntax.name << " " << i;
      step_option(options, row.syntax.name, 1.0f);
    }
    EXPECT_FALSE(row.is_given(options)) << row.syntax.name;
    step_option(options, row.syntax.name, -1.0f);
    EXPECT_TRUE(row.is_given(options)) << row.syntax.name;
  }
}

TEST(RenderOptionTable, UnknownNamesAreAnError) {
  EXPECT_THROW(render_option("--no-such"), std::out_of_range);
}

}  // namespace
}  // namespace barrido::cli
