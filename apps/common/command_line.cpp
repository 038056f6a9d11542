#include "command_line.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>

namespace muster {

Option& Option::required() {
    option_->required();
    return *this;
}

Option& Option::range(int low, int high) {
    option_->check(CLI::Range(low, high));
    return *this;
}

Option& Option::range(double low, double high) {
    option_->check(CLI::Range(low, high));
    return *this;
}

Option& Option::finite(double low, double high) {
    char range[64];
    std::snprintf(range, sizeof(range), "[%g - %g]", low, high);
    const auto check = [low, high, name = std::string(range)](const std::string& text) -> std::string {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (end != text.c_str() && *end == '\0' && value >= low && value <= high) return {};
        return "found " + text + ", expected a number in " + name;
    };
    option_->check(CLI::Validator(check, range));
    return *this;
}

Option& Option::oneOf(const std::vector<std::string>& words) {
    option_->check(CLI::IsMember(words));
    return *this;
}

Option& Option::existingFolder() {
    option_->check(CLI::ExistingDirectory);
    return *this;
}

Option& Option::check(const std::function<std::string(const std::string&)>& check) {
    option_->check(CLI::Validator(check, ""));
    return *this;
}

Option& Option::values(int count) {
    option_->expected(count);
    return *this;
}

Option& Option::separatedBy(char character) {
    option_->delimiter(character);
    return *this;
}

Option& Option::oneValueEach() {
    option_->allow_extra_args(false);
    return *this;
}

Option& Option::excludes(const Option& other) {
    option_->excludes(other.option_);
    return *this;
}

Option& Option::needs(const Option& other) {
    option_->needs(other.option_);
    return *this;
}

Option Subcommand::option(const std::string& name, std::string& value, const std::string& about) {
    return Option(app_->add_option(name, value, about));
}

Option Subcommand::option(const std::string& name, int& value, const std::string& about) {
    return Option(app_->add_option(name, value, about));
}

Option Subcommand::option(const std::string& name, double& value, const std::string& about) {
    return Option(app_->add_option(name, value, about));
}

Option Subcommand::option(const std::string& name, std::vector<std::string>& values,
                          const std::string& about) {
    return Option(app_->add_option(name, values, about));
}

Option Subcommand::option(const std::string& name, std::vector<double>& values, const std::string& about) {
    return Option(app_->add_option(name, values, about));
}

Option Subcommand::flag(const std::string& name, bool& value, const std::string& about) {
    return Option(app_->add_flag(name, value, about));
}

void Subcommand::footer(const std::string& text) {
    app_->footer(text);
}

Subcommand Subcommand::add(const std::string& name, const std::string& about) {
    app_->require_subcommand(1);
    return Subcommand(app_->add_subcommand(name, about), exitCode_);
}

void Subcommand::run(std::function<int()> action) {
    app_->callback([action = std::move(action), exitCode = exitCode_] { *exitCode = action(); });
}

CommandLine::CommandLine(const std::string& name, const std::string& about, const std::string& version,
                         const std::string& footer)
    : app_(std::make_unique<CLI::App>(about, name)) {
    app_->set_version_flag("--version", version);
    app_->require_subcommand(1);
    app_->footer(footer);
}

CommandLine::~CommandLine() = default;

Subcommand CommandLine::add(const std::string& name, const std::string& about) {
    return Subcommand(app_->add_subcommand(name, about), &exitCode_);
}

int CommandLine::run(int argc, char** argv) {
    try {
        app_->parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app_->exit(help);
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "%s: %s (see %s --help)\n", app_->get_name().c_str(), error.what(),
                     app_->get_name().c_str());
        return kExitUsage;
    }
    return exitCode_;
}

}  // namespace muster
