#include "command_line.h"

#include <doctest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace muster;

namespace {

/// What is written to a file descriptor while this lives.
class Capture {
public:
    explicit Capture(int descriptor)
        : descriptor_(descriptor), before_(::dup(descriptor)), file_(std::tmpfile()) {
        ::dup2(::fileno(file_), descriptor_);
    }
    ~Capture() {
        restore();
        std::fclose(file_);
    }
    /// Ends it and returns the text.
    std::string text() {
        restore();
        std::string all;
        std::rewind(file_);
        for (int c = std::fgetc(file_); c != EOF; c = std::fgetc(file_)) all += static_cast<char>(c);
        return all;
    }

private:
    void restore() {
        if (before_ < 0) return;
        std::cout.flush();
        std::fflush(nullptr);
        ::dup2(before_, descriptor_);
        ::close(before_);
        before_ = -1;
    }
    int descriptor_, before_;
    std::FILE* file_;
};

struct Outcome {
    int code;
    std::string out, error;
};

/// Runs a new command line, which `build` gives its subcommands, with these arguments.
Outcome runLine(const std::function<void(CommandLine&)>& build, std::vector<std::string> arguments) {
    CommandLine line("prog", "About.", "1.2.3", "Last words.");
    build(line);
    arguments.insert(arguments.begin(), "prog");
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    std::cout.flush();
    Capture out(STDOUT_FILENO), error(STDERR_FILENO);
    const int code = line.run(static_cast<int>(pointers.size()), pointers.data());
    return {code, out.text(), error.text()};
}

/// Exit code of `prog go ARGUMENTS` where `add` gives "go" its options. The action runs on success only.
int codeOf(const std::function<void(Subcommand&)>& add, std::vector<std::string> arguments) {
    int ran = 0;
    arguments.insert(arguments.begin(), "go");
    const Outcome outcome = runLine(
        [&](CommandLine& line) {
            Subcommand go = line.add("go", "Goes.");
            add(go);
            go.run([&] {
                ++ran;
                return kExitOk;
            });
        },
        arguments);
    CAPTURE(outcome.error);
    CHECK((outcome.code == kExitOk || outcome.code == kExitUsage));
    CHECK(ran == (outcome.code == kExitOk ? 1 : 0));
    CHECK(outcome.error.empty() == (outcome.code == kExitOk));
    return outcome.code;
}

}  // namespace

TEST_CASE("options, switches and positional arguments set their variables; others stay") {
    std::string text = "before", file;
    int whole = 1;
    double real = 1.0, other = 7.0;
    bool on = false, off = false;
    std::vector<std::string> words;
    const auto add = [&](Subcommand& go) {
        go.option("FILE", file, "A file.").required();
        go.option("-t,--text", text, "A text.");
        go.option("--whole", whole, "A whole number.");
        go.option("--real", real, "A number.");
        go.option("--other", other, "Another number.");
        go.option("--word", words, "Words.").oneValueEach();
        go.flag("--on", on, "A switch.");
        go.flag("--off", off, "Another one.");
    };
    CHECK(codeOf(add, {"--word", "a", "in.txt", "-t", "two words", "--whole=-3", "--on", "--real", "2.5e-1",
                       "--word", "b"}) == kExitOk);
    CHECK(file == "in.txt");
    CHECK(text == "two words");
    CHECK(whole == -3);
    CHECK(real == 0.25);
    CHECK(other == 7.0);
    CHECK(words == std::vector<std::string>{"a", "b"});
    CHECK(on);
    CHECK(!off);
}

TEST_CASE("a wrong command line ends with 2 and one line that names the program's help") {
    int whole = 0, ran = 0;
    std::string needed;
    const auto build = [&](CommandLine& line) {
        Subcommand go = line.add("go", "Goes.");
        go.option("--whole", whole, "A whole number.");
        go.option("NEEDED", needed, "Needed.").required();
        go.run([&] { return ++ran; });
    };
    const std::vector<std::vector<std::string>> wrong{{},
                                                      {"fly"},
                                                      {"--whole", "1"},
                                                      {"go"},
                                                      {"go", "x", "--unknown"},
                                                      {"go", "x", "-u"},
                                                      {"go", "x", "y"},
                                                      {"go", "x", "--whole"},
                                                      {"go", "x", "--whole", "two"},
                                                      {"go", "x", "--whole", "2.5"},
                                                      {"go", "x", "--whole", "99999999999"},
                                                      {"go", "x", "--whol", "2"}};
    for (const auto& arguments : wrong) {
        std::string all;
        for (const std::string& argument : arguments) all += " " + argument;
        CAPTURE(all);
        const Outcome outcome = runLine(build, arguments);
        CHECK(outcome.code == kExitUsage);
        CHECK(outcome.out.empty());
        CHECK(outcome.error.rfind("prog: ", 0) == 0);
        CHECK(outcome.error.find("(see prog --help)\n") == outcome.error.size() - 18);
        CHECK(std::count(outcome.error.begin(), outcome.error.end(), '\n') == 1);
    }
    CHECK(ran == 0);
}

TEST_CASE("the exit code is that of the action, and only the subcommand named runs") {
    for (const int code : {kExitOk, kExitFailure, kExitUsage, kExitNotReproduced}) {
        std::string ran;
        const auto build = [&](CommandLine& line) {
            for (const std::string name : {"one", "two", "three"}) {
                line.add(name, "About " + name + ".").run([&ran, name, code] {
                    ran += name;
                    return code;
                });
            }
        };
        const Outcome outcome = runLine(build, {"two"});
        CHECK(outcome.code == code);
        CHECK(ran == "two");
    }
}

TEST_CASE("help and version print to standard output, end with 0 and run nothing") {
    bool ran = false;
    int level = 3;
    const auto build = [&](CommandLine& line) {
        Subcommand go = line.add("go", "Goes somewhere.");
        go.option("--level", level, "How high.").range(1, 9);
        go.footer("Example: prog go --level 2");
        go.run([&] {
            ran = true;
            return kExitFailure;
        });
    };
    const auto shows = [&](const std::vector<std::string>& arguments, const std::string& words) {
        const Outcome outcome = runLine(build, arguments);
        CHECK(outcome.code == kExitOk);
        CHECK(outcome.error.empty());
        CHECK_MESSAGE(outcome.out.find(words) != std::string::npos, outcome.out);
    };
    shows({"--version"}, "1.2.3");
    for (const std::string words : {"About.", "Last words.", "go", "Goes somewhere."})
        shows({"--help"}, words);
    for (const std::string words : {"--level", "How high.", "[1 - 9]", "Example: prog go --level 2"})
        shows({"go", "--help"}, words);
    CHECK(!ran);
    CHECK(level == 3);
}

TEST_CASE("ranges hold their ends and nothing beyond") {
    int whole = 0;
    double real = 0.0;
    for (int value = -4; value <= 7; ++value) {
        const auto add = [&](Subcommand& go) { go.option("--n", whole, "N.").range(-2, 5); };
        const int code = codeOf(add, {"--n=" + std::to_string(value)});
        CHECK((code == kExitOk) == (value >= -2 && value <= 5));
        if (code == kExitOk) CHECK(whole == value);
    }
    const auto inRange = [&](const std::string& value) {
        return codeOf([&](Subcommand& go) { go.option("--x", real, "X.").range(0.5, 2.5); },
                      {"--x=" + value}) == kExitOk;
    };
    for (const std::string good : {"0.5", "1", "2.5", "1e0"}) CHECK(inRange(good));
    for (const std::string bad : {"0.4999", "2.5001", "-1", "inf", "x", "1x"}) CHECK(!inRange(bad));
}

TEST_CASE("a finite number is one number in its range, and no infinity or NaN") {
    double real = 0.0;
    const auto finite = [&](const std::string& value) {
        return codeOf([&](Subcommand& go) { go.option("--x", real, "X.").finite(-1.0, 1e9); },
                      {"--x=" + value}) == kExitOk;
    };
    for (const std::string good : {"-1", "0", "-0.5", "1e9", "12.25"}) {
        CHECK(finite(good));
        CHECK(real == std::stod(good));
    }
    for (const std::string bad : {"nan", "-nan", "inf", "-inf", "1e10", "-1.01", "1e", "1 2", "one", "3m"})
        CHECK(!finite(bad));
}

TEST_CASE("words, folders and checks of one's own") {
    std::string value;
    const auto oneOf = [&](Subcommand& go) { go.option("--v", value, "V.").oneOf({"red", "green"}); };
    for (const std::string word : {"red", "green"}) {
        CHECK(codeOf(oneOf, {"--v", word}) == kExitOk);
        CHECK(value == word);
    }
    for (const std::string word : {"blue", "Red", "re", "red,green"})
        CHECK(codeOf(oneOf, {"--v", word}) == kExitUsage);

    const auto folder = [&](Subcommand& go) { go.option("--v", value, "V.").existingFolder(); };
    CHECK(codeOf(folder, {"--v", std::filesystem::temp_directory_path().string()}) == kExitOk);
    CHECK(codeOf(folder, {"--v", "/nowhere"}) == kExitUsage);
    CHECK(codeOf(folder, {"--v", "/proc/self/status"}) == kExitUsage);  // A file.

    const auto build = [&](CommandLine& line) {
        Subcommand go = line.add("go", "Goes.");
        go.option("--v", value, "V.").check([](const std::string& text) {
            return text.size() % 2 == 0 ? std::string() : "found " + text + ", expected an even length";
        });
        go.run([] { return kExitOk; });
    };
    CHECK(runLine(build, {"go", "--v", "ab"}).code == kExitOk);
    const Outcome odd = runLine(build, {"go", "--v", "abc"});
    CHECK(odd.code == kExitUsage);
    CHECK(odd.error.find("found abc, expected an even length") != std::string::npos);
}

TEST_CASE("options that exclude or need each other") {
    std::string a, b;
    const auto excluding = [&](Subcommand& go) {
        const Option first = go.option("--a", a, "A.");
        go.option("--b", b, "B.").excludes(first);
    };
    CHECK(codeOf(excluding, {}) == kExitOk);
    CHECK(codeOf(excluding, {"--a", "1"}) == kExitOk);
    CHECK(codeOf(excluding, {"--b", "1"}) == kExitOk);
    CHECK(codeOf(excluding, {"--a", "1", "--b", "1"}) == kExitUsage);
    CHECK(codeOf(excluding, {"--b", "1", "--a", "1"}) == kExitUsage);
    const auto needing = [&](Subcommand& go) {
        const Option first = go.option("--a", a, "A.");
        go.option("--b", b, "B.").needs(first);
    };
    CHECK(codeOf(needing, {}) == kExitOk);
    CHECK(codeOf(needing, {"--a", "1"}) == kExitOk);
    CHECK(codeOf(needing, {"--b", "1"}) == kExitUsage);
    CHECK(codeOf(needing, {"--b", "1", "--a", "1"}) == kExitOk);
}

TEST_CASE("several values: so many, separated by a character, or one each time") {
    std::vector<double> numbers;
    std::vector<std::string> words;
    std::string rest;
    const auto four = [&](Subcommand& go) { go.option("--box", numbers, "Box.").values(4); };
    CHECK(codeOf(four, {"--box", "-1", "2", "0.5", "4"}) == kExitOk);
    CHECK(numbers == std::vector<double>{-1, 2, 0.5, 4});
    CHECK(codeOf(four, {"--box", "1", "2", "3"}) == kExitUsage);
    CHECK(codeOf(four, {"--box", "1", "2", "3", "4", "5"}) == kExitUsage);
    const auto separated = [&](Subcommand& go) { go.option("--list", words, "List.").separatedBy(','); };
    words.clear();
    CHECK(codeOf(separated, {"--list", "mesh,places,x"}) == kExitOk);
    CHECK(words == std::vector<std::string>{"mesh", "places", "x"});
    const auto each = [&](Subcommand& go) {
        go.option("--set", words, "Set.").oneValueEach();
        go.option("REST", rest, "Rest.");
    };
    words.clear();
    CHECK(codeOf(each, {"--set", "a=1", "file", "--set", "b=2"}) == kExitOk);
    CHECK(words == std::vector<std::string>{"a=1", "b=2"});
    CHECK(rest == "file");
}
