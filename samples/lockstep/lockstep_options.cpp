#include "lockstep_options.h"

#include <charconv>
#include <cstdio>
#include <string_view>

namespace lockstep {
namespace {

muster::Result<double> number(std::string_view name, const char* text, double low, double high) {
    const std::string_view digits = text == nullptr ? "" : text;
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc() && end == digits.data() + digits.size() && value >= low && value <= high)
        return value;
    char range[80];
    std::snprintf(range, sizeof range, "', expected a number from %g to %g", low, high);
    return muster::invalidArgument(std::string(name) + " is '" + std::string(digits) + range);
}

/// A named number: where it goes and its range.
struct Field {
    std::string_view name;
    double low, high;
    void (*set)(Options& options, double value);
};

constexpr Field kFields[] = {
    {"--minutes", 0.01, 600.0, [](Options& o, double v) { o.seconds = 60.0 * v; }},
    {"--every", 0.1, 3600.0, [](Options& o, double v) { o.every = v; }},
    {"--people", 1, 1000, [](Options& o, double v) { o.people = static_cast<std::int32_t>(v); }},
    {"--patience", 0.1, 3600.0, [](Options& o, double v) { o.patience = v; }},
    {"--seed", 0, 1e9, [](Options& o, double v) { o.link.seed = static_cast<std::uint64_t>(v); }},
    {"--delay", 0.0, 1000.0, [](Options& o, double v) { o.link.delay = v; }},
    {"--jitter", 0.0, 1000.0, [](Options& o, double v) { o.link.jitter = v; }},
    {"--loss", 0.0, 0.95, [](Options& o, double v) { o.link.loss = v; }},
    {"--garbage", 0.0, 1.0, [](Options& o, double v) { o.link.garbage = v; }},
    {"--port", 1, 65535, [](Options& o, double v) { o.port = static_cast<std::uint16_t>(v); }},
    {"--peer", 1, 65535, [](Options& o, double v) { o.peer = static_cast<std::uint16_t>(v); }},
};

const Field* fieldOf(std::string_view name) {
    for (const Field& field : kFields)
        if (field.name == name) return &field;
    return nullptr;
}

}  // namespace

muster::Result<Options> readOptions(int count, const char* const* arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--real") {
            options.real = true;
        } else if (const Field* field = fieldOf(argument)) {
            ++i;
            const muster::Result<double> value = number(argument, i < count ? arguments[i] : nullptr,
                                                        field->low, field->high);
            if (!value.ok()) return value.status();
            field->set(options, *value);
        } else if (argument.starts_with("-")) {
            return muster::invalidArgument("no option is called '" + std::string(argument) + "'");
        } else {
            options.folder = argument;
        }
    }
    if ((options.port == 0) != (options.peer == 0))
        return muster::invalidArgument("--port and --peer go together");
    if (options.port != 0 && options.port == options.peer)
        return muster::invalidArgument("--port and --peer are the same");
    return options;
}

const char* usage() {
    return "Usage: lockstep [FOLDER] [--minutes M] [--real] [--people N] [--every SECONDS] [--seed N]\n"
           "                [--delay MS] [--jitter MS] [--loss SHARE] [--garbage SHARE] [--patience "
           "SECONDS]\n"
           "                [--port A --peer B]   one peer only; the other is started with the ports "
           "exchanged\n"
           "FOLDER keeps the logs. --real goes at the pace of the clock, else as fast as both can.\n";
}

}  // namespace lockstep
