// The text layer of FlexNC templates and sets: fnc-4.2-tmpl, fnc-4.2-param, fnc-4.2-need, fnc-4.4-order,
// fnc-4.5-tmps, fnc-4.5-pmc.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "core/nc/text/template_set.h"

namespace proveout::nc {
namespace {

using Files = std::map<std::string, std::string>;

struct Outcome {
  std::string text;    ///< of the program; empty after an error
  std::string errors;  ///< as a person sees them
  std::optional<FilledProgram> filled;
};

Outcome fill(const Files& files, const std::string& main, const TemplateValues& values = {},
             TextEncoding encoding = TextEncoding::kAuto) {
  const auto load = [&](const std::string& name) -> Result<ProgramText> {
    const auto file = files.find(name);
    if (file == files.end()) return inputError(name + ": no such file");
    return ProgramText{name, name, file->second};
  };
  Diagnostics diagnostics;
  Outcome out;
  out.filled = fillProgram({main, main, files.at(main)}, values, load, encoding, diagnostics);
  if (out.filled) out.text = out.filled->text();
  for (const Diagnostic& d : diagnostics.all()) out.errors += formatDiagnostic(d);
  EXPECT_EQ(out.filled.has_value(), !diagnostics.hasErrors());
  return out;
}

Outcome fillText(const std::string& text, const TemplateValues& values) {
  return fill({{"a.tmpl", text}}, "a.tmpl", values);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Templates, TheManualsLines) {
  EXPECT_EQ(fillText("G00X([C]/2)Z[B]\n", {{"C", "50"}, {"B", "16"}}).text, "G00X(50/2)Z16\n");
  const TemplateValues cone{{"D", "100"}, {"d1", "25"}, {"Z", "10"}, {"Z1", "15"},
                            {"P", "2"},   {"C", "2"},   {"B", "3"},  {"V", "0"}};
  EXPECT_EQ(fillText("G77X[D]A[d1]Y[Z]Z[Z1]P[P]C[C]B[B]V[V]\n", cone).text, "G77X100A25Y10Z15P2C2B3V0\n");
}

TEST(Templates, NamesAreAnyCharactersAndTheirCaseCounts) {
  EXPECT_EQ(fillText("X[d]Z[D]A[Ø загот.]\n", {{"d", "1"}, {"D", "2"}, {"Ø загот.", "-3.5"}}).text,
            "X1Z2A-3.5\n");
  EXPECT_EQ(fillText("X[d]\n", {{"D", "1"}}).errors,
            "a.tmpl: error[template]: a.tmpl has no parameter [D]; do you mean [d]?\n");
}

TEST(Templates, NumberTextStandsAsItWasEntered) {
  EXPECT_EQ(fillText("X[d]Z[d]\n", {{"d", "007.500"}}).text, "X007.500Z007.500\n");
}

TEST(Templates, ExpressionsVariablesAndCommentsPass) {
  const std::string text = "// [D] of [what]\nP1100=[D]*SIN(30)-COS(P8100)/TAN(45)\nG77X(P1100)A[D]\n";
  EXPECT_EQ(fillText(text, {{"D", "40"}}).text,
            "// 40 of [what]\nP1100=40*SIN(30)-COS(P8100)/TAN(45)\nG77X(P1100)A40\n");
}

constexpr const char* kDeclared =
    "//@ [D] = 40, 10..200: diameter of the bar, mm\n  //@ [L], 0..\n//@ [A] = -1.5\n//@ [N]: of passes\n"
    "X[D]Z[L]A[A]K[N]\n";

TEST(Templates, DeclarationsTellMeaningDefaultAndRange) {
  Diagnostics diagnostics;
  const auto read = readTemplate({"a.tmpl", "a.tmpl", kDeclared}, TextEncoding::kAuto, diagnostics);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->parameters.size(), 4u);
  const TemplateParameter &d = read->parameters[0], &l = read->parameters[1], &n = read->parameters[3];
  EXPECT_EQ(d.meaning, "diameter of the bar, mm");
  EXPECT_EQ(d.value, "40");
  EXPECT_EQ(d.min, 10.0);
  EXPECT_EQ(d.max, 200.0);
  EXPECT_EQ(l.min, 0.0);
  EXPECT_FALSE(l.max || l.value);
  EXPECT_TRUE(d.used && l.used && n.used);
  EXPECT_EQ(n.meaning, "of passes");
}

TEST(Templates, LinesKeepTheirNumbers) {
  const Outcome out = fillText(kDeclared, {{"L", "5"}, {"N", "2"}});
  EXPECT_EQ(out.text, "\n\n\n\nX40Z5A-1.5K2\n");
  EXPECT_EQ(out.filled->origins.lines[4].line, 5u);
}

TEST(Templates, ADeclarationBehindTheUseCounts) {
  EXPECT_EQ(fillText("X[D]\n//@ [D] = 3\n", {}).text, "X3\n\n");
}

TEST(Templates, EveryFieldMustBeFilled) {
  EXPECT_EQ(
      fillText("G00X[D]\nZ[L1]\n", {{"D", "1"}}).errors,
      "a.tmpl:2:2: error[template]: [L1] has no value: all fields must be filled in\n    Z[L1]\n     ^~~~\n");
  EXPECT_TRUE(has(fillText("X[D]\n", {{"D", ""}}).errors, "[D] is empty: all fields must be filled in"));
}

TEST(Templates, WrongNamesNameTheNearest) {
  EXPECT_TRUE(has(fillText("X[length]\n", {{"lenght", "1"}}).errors,
                  "a.tmpl has no parameter [lenght]; do you mean [length]?"));
}

TEST(Templates, ValuesAreNumbersInTheirRange) {
  for (const char* bad : {"4O", "1e3", "nan", "inf", "1 2", "0x10", "1,5", "+1", "--1", "X", " 1"})
    EXPECT_TRUE(has(fillText("X[D]\n", {{"D", bad}}).errors, "[D] must be a decimal number")) << bad;
  const auto errors = [](const std::string& d) {
    return fillText(kDeclared, {{"D", d}, {"L", "0"}, {"N", "1"}}).errors;
  };
  EXPECT_TRUE(has(errors("9.99"), "[D] must be from 10 to 200, not 9.99"));
  EXPECT_TRUE(has(errors("201"), "[D] must be from 10 to 200, not 201"));
  EXPECT_EQ(errors("10") + errors("200"), "");
  EXPECT_TRUE(has(fillText(kDeclared, {{"L", "-1"}, {"N", "1"}}).errors, "[L] must be at least 0, not -1"));
}

TEST(Templates, BracketsHavePartnersAndNames) {
  const std::map<std::string, std::string> wrong{
      {"X[D\n", "a.tmpl:1:2: error[template]: [ without ]"},
      {"X D]\n", "a.tmpl:1:4: error[template]: ] without ["},
      {"X[]\n", "a.tmpl:1:2: error[template]: a parameter without name"},
      {"X[A[B]]\n", "a.tmpl:1:2: error[template]: [ without ]"},
      {"X[A//]\n", "a.tmpl:1:2: error[template]: [ without ]"},
      {"//@ D = 1\n", "a.tmpl:1:4: error[template]: a declaration is //@"},
      {"//@ [D] = x\n", "a.tmpl:1:8: error[template]: between name and meaning"},
      {"//@ [D] = 1, 5\n", "a.tmpl:1:8: error[template]: between name and meaning"},
      {"//@ [D], 5..1\n", "a.tmpl:1:8: error[template]: the range is empty"},
      {"//@ [D]\n//@ [D]\n", "a.tmpl:2:5: error[template]: [D] is declared in line 1 already"},
  };
  for (const auto& [text, error] : wrong) EXPECT_TRUE(has(fillText(text, {}).errors, error)) << text;
  EXPECT_TRUE(has(fillText("//@ [D] = 5, 10..20\nX[D]\n", {}).errors,
                  "a.tmpl:1:8: error[template]: the default is not in the range"));
}

TEST(Templates, ContainersAreRefused) {
  for (const std::string& bytes :
       {std::string("BM6\x04"), std::string("T\0M\0", 4), std::string("PK\x03\x04zip")})
    EXPECT_TRUE(has(fillText(bytes, {}).errors, "export as .pmc (Save Text)"));
}

TEST(Templates, EncodingsAreThoseOfPrograms) {
  const std::string koi8 = "// \xC4\xC9\xC1\xCD\xC5\xD4\xD2\nX[\xE4]\n",
                    cp1251 = "// \xE4\xE8\xE0\xEC\xE5\xF2\xF0\nX[\xC4]\n";
  for (const auto& [bytes, encoding] :
       {std::pair{koi8, TextEncoding::kKoi8R}, std::pair{cp1251, TextEncoding::kCp1251}})
    EXPECT_EQ(fill({{"a.tmpl", bytes}}, "a.tmpl", {{"Д", "1"}}, encoding).text, "// диаметр\nX1\n");
  EXPECT_TRUE(has(fill({{"a.tmpl", koi8}}, "a.tmpl", {}, TextEncoding::kUtf8).errors, "is not utf-8 text"));
}

const Files kSet{
    {"1БЛ. TSF.tmpl", "T[T]M06D[T]\nS[S]M03\nG98F[F]\n"},
    {"cone.tmpl", "//@ [V] = 0\nG77X[D]A[d1]Y[Z]Z[Z1]P[P]C[C]B[B]V[V]\n"},
    {"end.tmpl", "G81X[X]Z[Z]\n"},
};

Outcome fillSet(const std::string& text, const TemplateValues& values = {}) {
  Files files = kSet;
  files["part.tmps"] = text;
  return fill(files, "part.tmps", values);
}

/// The order of the manual's 4.4: start block, roughing, end block.
TEST(TemplateSets, ProgramOfStartRoughingAndEnd) {
  const Outcome out = fillSet(
      "@ \"1БЛ. TSF.tmpl\" T=1;S=222;F=120\n"
      "@cone.tmpl D=60; d1=40; Y=1\n",
      {});
  EXPECT_TRUE(has(out.errors, "part.tmps:2:25: error[template]: cone.tmpl has no parameter [Y]"))
      << out.errors;
  const Outcome whole = fillSet(
      "@ \"1БЛ. TSF.tmpl\" T=1;S=222;F=120\n"
      "@cone.tmpl D=60; d1=40;Z=10;Z1=0;P=3;C=2;B=2;V=15\n"
      "@ end.tmpl X=100;Z=100;\n"
      "M02\n");
  EXPECT_EQ(whole.text, "T1M06D1\nS222M03\nG98F120\n\nG77X60A40Y10Z0P3C2B2V15\nG81X100Z100\nM02\n")
      << whole.errors;
}

TEST(TemplateSets, LinesAreThoseOfTheirFiles) {
  const Outcome out = fillSet("// set\n@ end.tmpl X=1;Z=2\nG04\n@ end.tmpl X=3;Z=4\n");
  ASSERT_TRUE(out.filled);
  const TextOrigins& origins = out.filled->origins;
  ASSERT_EQ(origins.lines.size(), 4u);
  const auto place = [&](std::size_t i) {
    return origins.files[origins.lines[i].file] + ":" + std::to_string(origins.lines[i].line);
  };
  EXPECT_EQ(place(0), "part.tmps:1");
  EXPECT_EQ(place(1), "end.tmpl (part.tmps:2):1");
  EXPECT_EQ(place(2), "part.tmps:3");
  EXPECT_EQ(place(3), "end.tmpl (part.tmps:4):1");
  EXPECT_EQ(out.filled->files.size(), 2u);
}

TEST(TemplateSets, ASetHasParametersOfItsOwn) {
  EXPECT_EQ(fillSet("//@ [R] = 7\n@ end.tmpl X=[R];Z=[Q]\nG00X[R]\n", {{"Q", "9"}}).text,
            "\nG81X7Z9\nG00X7\n");
}

TEST(TemplateSets, ErrorsNameTheLineOfTheSet) {
  EXPECT_TRUE(has(fillSet("@ end.tmpl X=1\n").errors,
                  "end.tmpl:1:9: error[template]: [Z] has no value: all fields must be filled in\n"
                  "    G81X[X]Z[Z]\n"));
  EXPECT_TRUE(has(fillSet("@ end.tmpl X=1\n").errors, "in the set part.tmps:1: @ end.tmpl X=1"));
  EXPECT_TRUE(
      has(fillSet("@ gone.tmpl\n").errors, "part.tmps:1:3: error[template]: gone.tmpl: no such file"));
  EXPECT_TRUE(has(fillSet("@ part.tmps\n").errors, "a set holds templates and program text, no other sets"));
  EXPECT_TRUE(has(fillSet("@\n").errors, "part.tmps:1:1: error[template]: a template of a set is"));
  EXPECT_TRUE(has(fillSet("@ \"end.tmpl X=1\n").errors, "a template of a set is"));
  EXPECT_TRUE(has(fillSet("@ end.tmpl X\n").errors, "NAME=VALUE is wanted here"));
  EXPECT_TRUE(has(fillSet("@ end.tmpl X=1;X=2;Z=1\n").errors, "[X] has two values"));
  EXPECT_TRUE(has(fillSet("@ end.tmpl X=;Z=1\n").errors, "[X] is empty"));
}

/// Whatever the bytes: a program without a parameter that stands open, or errors, and both soon.
TEST(TemplateSets, RandomTextEndsInAProgramOrInErrors) {
  std::mt19937 random(4);
  const std::string letters = "[]@//.=;:\"\n\r \tXD1\xD0\x94\xFF{}-";
  for (int round = 0; round < 3000; ++round) {
    std::string text = round % 3 == 0 ? "//@ [D]" : round % 3 == 1 ? "@ end.tmpl X=" : "";
    for (int n = static_cast<int>(random() % 60); n > 0; --n) text += letters[random() % letters.size()];
    const Outcome out = fillSet(text, {});
    EXPECT_EQ(out.filled.has_value(), out.errors.empty()) << text;
  }
}

TEST(TemplateSets, HugeTextsAreRefused) {
  EXPECT_TRUE(has(fillText(std::string(kMaxTemplateBytes + 1, 'X'), {}).errors, "larger than 16 MiB"));
  std::string many;
  for (int i = 0; i < 1001; ++i) many += "X[a" + std::to_string(i) + "]\n";
  EXPECT_TRUE(has(fillText(many, {}).errors, "more than 1000 parameters"));
  // A short set that would fill hundreds of megabytes.
  Files files{{"big.tmpl", std::string(1 << 20, 'X') + "\n"}, {"a.tmps", ""}};
  for (int i = 0; i < 300; ++i) files["a.tmps"] += "@ big.tmpl\n";
  EXPECT_TRUE(has(fill(files, "a.tmps").errors, "the program gets larger than 256 MiB"));
}

}  // namespace
}  // namespace proveout::nc
