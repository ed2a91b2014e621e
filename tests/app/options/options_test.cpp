// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the table of options: values, proposals, and parsing according to the table.
#include <gtest/gtest.h>

#include <limits>

#include "app/options/completion.hpp"
#include "app/options/did_you_mean.hpp"
#include "app/options/help_text.hpp"
#include "app/options/man_page.hpp"
#include "app/options/option_values.hpp"
#include "app/options/parse_arguments.hpp"

namespace alphascope {
namespace {

TEST(DidYouMean, ProposesTheNearestAndNothingFar) {
  const std::vector<std::string> words{"--alpha", "--altlocs", "--solvent", "--tetrahedra-only"};
  EXPECT_EQ(did_you_mean("--aplha", words), " Did you mean \"--alpha\"?");
  EXPECT_EQ(did_you_mean("--ALPHA", words), " Did you mean \"--alpha\"?");
  EXPECT_EQ(did_you_mean("--tetra", words), " Did you mean \"--tetrahedra-only\"?");
  EXPECT_EQ(did_you_mean("--solvnet", words), " Did you mean \"--solvent\"?");
  EXPECT_EQ(did_you_mean("--altloc", words), " Did you mean \"--altlocs\"?");
  EXPECT_EQ(did_you_mean("--frobnicate", words), "");
  EXPECT_EQ(did_you_mean("--qwertyab", {"--asdfghba"}), "")
      << "two letters swapped, and six others";
  EXPECT_EQ(did_you_mean("-x", {"-q", "-v"}), "") << "any two such are near each other";
  EXPECT_EQ(did_you_mean("-xy", {"-xz"}), " Did you mean \"-xz\"?") << "of three letters";
  EXPECT_EQ(did_you_mean("bac", {"abc"}), " Did you mean \"abc\"?") << "one slip, not two";
  EXPECT_EQ(did_you_mean("", words), "");
  EXPECT_EQ(did_you_mean(std::string(100'000, 'a'), words), "") << "and is not slow";
}

struct Values {
  bool light = false, balls = true;
  double alpha = 0.5;
  int threads = 0;
  std::string engine = "auto", note;
  std::vector<std::string> chains;
  std::vector<int> counts{1};
  std::vector<std::string> files;
};

OptionProgram table(Values& v) {
  OptionProgram program;
  program.name = "prog";
  program.text = "Does it";
  program.version = "1";
  OptionCommand run;
  run.name = "run";
  run.text = "Runs";
  run.options = {texts_option({"FILE", "FILE", "Input"}, v.files),
                 flag_option("-l,--light", "Light", v.light),
                 flag_option("--no-balls", "None", v.balls, false),
                 number_option({"-a,--alpha", "A", "Alpha"}, v.alpha, {-10, 10, "Å²"}),
                 whole_number_option({"--threads", "N", "Threads"}, v.threads, {0, 8}),
                 choice_option({"--engine", "auto|cpu", "Engine"}, v.engine),
                 text_option({"--note", "TEXT", "It's a \"note\": [100 %] -x"}, v.note),
                 texts_option({"--chain", "ID", "Chains"}, v.chains),
                 whole_numbers_option({"--counts", "N", "Counts"}, v.counts, {0, 100})};
  run.check = [&v] {
    if (v.note == "forbidden") throw std::invalid_argument("--note is forbidden");
  };
  program.commands = {run};
  add_standard_options(program);
  return program;
}

ParsedArguments parse(const OptionProgram& program, std::vector<const char*> words) {
  words.insert(words.begin(), "prog");
  return parse_arguments(program, static_cast<int>(words.size()), words.data());
}

TEST(Options, AreSetInEveryOrdinaryWayOfWritingThem) {
  Values v;
  const OptionProgram program = table(v);
  const ParsedArguments parsed =
      parse(program, {"run", "a", "-la-2.5", "--chain", "A,B", "b", "--chain=C", "--counts", "3,4",
                      "--no-balls", "--note", "-x --y", "--engine", "cpu", "--", "--c"});
  ASSERT_FALSE(parsed.ended) << parsed.text;
  EXPECT_EQ(parsed.command->name, "run");
  EXPECT_TRUE(v.light);
  EXPECT_FALSE(v.balls);
  EXPECT_EQ(v.alpha, -2.5);
  EXPECT_EQ(v.chains, (std::vector<std::string>{"A", "B", "C"}));
  EXPECT_EQ(v.counts, (std::vector<int>{3, 4})) << "instead of the default";
  EXPECT_EQ(v.note, "-x --y");
  EXPECT_EQ(v.engine, "cpu");
  EXPECT_EQ(v.files, (std::vector<std::string>{"a", "b", "--c"}));
}

TEST(Options, RefuseWhatIsNoValue) {
  for (const std::vector<const char*>& words :
       std::vector<std::vector<const char*>>{{"run", "--alpha", "nan"},
                                             {"run", "--alpha", "inf"},
                                             {"run", "--alpha", "1e400"},
                                             {"run", "--alpha", "10.1"},
                                             {"run", "--alpha", "1 "},
                                             {"run", "--alpha", ""},
                                             {"run", "--alpha", "0x10"},
                                             {"run", "--threads", "1e0"},
                                             {"run", "--threads", "99999999999"},
                                             {"run", "--engine", "gpu"},
                                             {"run", "--counts", "1,,2"},
                                             {"run", "--note", "forbidden"},
                                             {"run", "-z"},
                                             {"walk"},
                                             {}}) {
    Values v;
    const OptionProgram program = table(v);
    const ParsedArguments parsed = parse(program, words);
    ASSERT_TRUE(parsed.ended) << (words.empty() ? "nothing" : words.back());
    EXPECT_EQ(parsed.exit_code, 2);
    EXPECT_TRUE(parsed.text.starts_with("prog: ")) << parsed.text;
    EXPECT_NE(parsed.text.find("\nUsage: prog "), parsed.text.npos) << parsed.text;
  }
}

TEST(Options, RefuseAnEmptyValueUnlessItMeansSomething) {
  for (const std::vector<const char*>& words :
       std::vector<std::vector<const char*>>{{"run", "--note", ""},
                                             {"run", "--note="},
                                             {"run", "--note=", "x"},
                                             {"run", "-a", ""},
                                             {"run", "--engine", ""},
                                             {"run", "--threads", ""},
                                             {"run", "--counts", "1,"},
                                             {"run", "a", ""},
                                             {"run", "--", ""}}) {
    Values v;
    const OptionProgram program = table(v);
    const ParsedArguments parsed = parse(program, words);
    ASSERT_TRUE(parsed.ended) << words[1];
    EXPECT_EQ(parsed.exit_code, 2);
    const bool said = parsed.text.find("is empty; give") != parsed.text.npos ||
                      parsed.text.find("nothing between two commas") != parsed.text.npos;
    EXPECT_TRUE(said) << parsed.text;
  }
  Values v;
  OptionProgram program = table(v);
  EXPECT_TRUE(parse(program, {"run", "--chain", ""}).ended);
  for (Option& option : program.commands[0].options) {
    if (option.names == "--chain") option.may_be_empty = true;
  }
  EXPECT_FALSE(parse(program, {"run", "--chain", "A,"}).ended);
  EXPECT_EQ(v.chains, (std::vector<std::string>{"A", ""}));
  EXPECT_NE(parse(program, {"run", "--light="}).text.find("--light takes no value"),
            std::string::npos);
}

TEST(Options, HelpIsACommandToo) {
  Values v;
  const OptionProgram program = table(v);
  EXPECT_EQ(parse(program, {"help"}).text, help_text(program, nullptr));
  EXPECT_EQ(parse(program, {"help", "run"}).text, help_text(program, &program.commands[0]));
  EXPECT_EQ(parse(program, {"help", "rnu"}).exit_code, 2);
  EXPECT_EQ(parse(program, {"-V"}).text, "prog 1\n");
  EXPECT_EQ(parse(program, {"run", "--version"}).text, "prog 1\n");
}

TEST(Options, HelpIsOfTheProgramOrOfOneCommand) {
  Values v;
  const OptionProgram program = table(v);
  EXPECT_EQ(usage_line(program, nullptr), "prog COMMAND [OPTIONS] FILE...");
  EXPECT_EQ(usage_line(program, &program.commands[0]), "prog run [OPTIONS] [FILE...]");
  const std::string whole = help_text(program, nullptr);
  const std::string of_run = help_text(program, &program.commands[0]);
  const std::string commands =
      "\nCommands (each has --help):\n  run                           Runs\n";
  EXPECT_NE(whole.find(commands), whole.npos) << whole;
  EXPECT_EQ(of_run.find("Commands"), of_run.npos) << of_run;
  EXPECT_TRUE(
      of_run.starts_with("Runs\n\nUsage: prog run [OPTIONS] [FILE...]\n\nArguments:\n"
                         "  FILE...                       Input\n"))
      << of_run;
  EXPECT_NE(of_run.find("  --note TEXT                   It's a \"note\": [100 %] -x\n"),
            of_run.npos);
}

// No line is longer than 100 columns, and none breaks within a default value.
TEST(Options, LongExplanationsAreWrapped) {
  std::string value;
  OptionProgram program;
  program.name = "prog";
  std::string words;  // columns 32 to 95
  for (int n = 0; n < 8; ++n) words += words.empty() ? "a123456" : " a123456";
  program.options = {with_default(text_option({"--value", "V", words + " behind"}, value), "1 2"),
                     text_option({"--a-name-that-is-long-by-itself", "V", "Text"}, value)};
  const std::string help = help_text(program, nullptr);
  EXPECT_NE(help.find("  --value V                     " + words + "\n" + std::string(32, ' ') +
                      "behind (default: 1 2)\n"),
            help.npos)
      << help;
  EXPECT_NE(help.find("  --a-name-that-is-long-by-itself V\n" + std::string(32, ' ') + "Text\n"),
            help.npos)
      << help;
}

TEST(Options, ComplaintsNameWhatIsWrong) {
  double alpha = 0;
  int rows = 0;
  std::string file;
  OptionProgram program;
  program.name = "prog";
  program.options = {text_option({"FILE", "FILE", "Input"}, file),
                     number_option({"--alpha", "A", "Alpha"}, alpha, {-10, 10, "Å²"}),
                     whole_number_option({"--rows", "N", "Rows"}, rows, {0, 1'000'000'000})};
  const auto complaint = [&](const std::vector<const char*>& words) {
    const std::string text = parse(program, words).text;
    return text.substr(0, text.find('\n'));
  };
  EXPECT_EQ(complaint({"a", "b"}), "prog: too many arguments: b.");
  EXPECT_EQ(complaint({"a", "--alpha"}), "prog: --alpha needs a value.");
  EXPECT_EQ(complaint({"a", "--alpha", "1", "--alpha", "2"}),
            "prog: --alpha can be given only once.");
  EXPECT_EQ(complaint({"a", "--alpha", ""}),
            "prog: --alpha: the value is empty; give A, or leave --alpha out.");
  EXPECT_EQ(complaint({"a", "--rows", "-1"}),
            "prog: --rows: \"-1\" is not a whole number from 0 to 1000000000.");
}

TEST(Options, AnswersEndTheProgramWithoutAnError) {
  Values v;
  const OptionProgram program = table(v);
  EXPECT_EQ(parse(program, {"--version"}).text, "prog 1\n");
  EXPECT_EQ(parse(program, {"--help"}).text, help_text(program, nullptr));
  EXPECT_EQ(parse(program, {"run", "-h"}).text, help_text(program, &program.commands[0]));
  EXPECT_EQ(parse(program, {"--man-page"}).text, man_page(program));
  EXPECT_EQ(parse(program, {"--completion", "fish"}).text, completion_script(program, "fish"));
  const ParsedArguments wrong = parse(program, {"--completion", "bsah"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.text.find("Did you mean \"bash\"?"), wrong.text.npos) << wrong.text;
}

TEST(Options, TextIsEscapedForManualAndShells) {
  Values v;
  const OptionProgram program = table(v);
  const std::string page = man_page(program);
  EXPECT_NE(page.find("It\\(aqs a \"note\": [100 %] \\-x"), page.npos) << page;
  // Quotes, colons and brackets would end the text that contains them.
  for (const char* shell : {"zsh", "fish"}) {
    const std::string script = completion_script(program, shell);
    EXPECT_NE(script.find("It s a |note|"), script.npos) << script;
  }
}

TEST(Options, ManualPageHasShortLinesAndItsSections) {
  Values v;
  OptionProgram program = table(v);
  program.text =
      "A text with many words " + std::string(48, 'x') + " .Dot behind the end of a line";
  program.date = "2026-11-27";
  program.environment = {{"A_VARIABLE", "Å Å Å Å Å Å Å Å Å Å Å Å Å Å Å Å Å Å Å Å Å"}};
  program.files = {{"~/a-file", "A file"}};
  program.see_also = {"one-two(1)", "three(7)"};
  program.notes = {{"Notes", {"  two blanks " + std::string(70, 'y') + " z"}}};
  const std::string page = man_page(program);
  EXPECT_NE(page.find(".TH PROG 1 \"2026-11-27\" \"prog 1\"\n"), page.npos) << page;
  EXPECT_NE(page.find("x\n\\&.Dot behind"), page.npos) << page;
  EXPECT_NE(page.find(".SH ENVIRONMENT\n.TP\n\\fBA_VARIABLE\\fR\nÅ Å"), page.npos) << page;
  EXPECT_NE(page.find(".SH FILES\n.TP\n\\fB\\(ti/a\\-file\\fR\nA file.\n"), page.npos) << page;
  EXPECT_NE(page.find(".SH SEE ALSO\n.BR one\\-two (1) ,\n.BR three (7)\n"), page.npos) << page;
  // Lines of notes stay lines, because \ joins their parts.
  EXPECT_NE(page.find("  two blanks \\\n" + std::string(70, 'y') + " z\n"), page.npos) << page;
  // troff sees \[u00C5] for each Å.
  EXPECT_EQ(page.find("Å Å Å Å Å Å Å Å Å Å"), page.npos) << page;
}

}  // namespace
}  // namespace alphascope
