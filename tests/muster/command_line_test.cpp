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
