#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/appearance_text.h"
#include "files/scenario/fields.h"

namespace muster {
namespace {

std::string numberText(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.10g", value);
    return buffer;
}

std::string expectation(const NumberRange& range) {
    std::string text = range.whole ? "a whole number in [" : "a number in [";
    text += numberText(range.minimum) + ", " + numberText(range.maximum) + "]";
    if (range.unit != "1") text += " " + std::string(range.unit);
    return text;
}

std::string listNames(const std::vector<std::string>& names) {
    std::string text = "one of";
    for (const std::string& name : names) text += (&name == &names.front() ? " \"" : ", \"") + name + "\"";
    return text;
}

}  // namespace

FieldReader::FieldReader(const Json& object, std::string path, std::string& failure)
    : object_(&object), path_(std::move(path)), failure_(&failure) {
    if (!object.isObject()) failAt(path_, describeJson(object), "an object");
}

std::string FieldReader::pathOf(std::string_view key) const {
    if (key.empty()) return path_;
    if (key.find('.') != std::string_view::npos) return path_ + "[\"" + std::string(key) + "\"]";
    return path_ + "." + std::string(key);
}

void FieldReader::failAt(const std::string& path, const std::string& found, const std::string& expected) {
    if (failure_->empty()) *failure_ = path + ": found " + found + ", expected " + expected;
}

void FieldReader::fail(std::string_view key, const std::string& found, const std::string& expected) {
    failAt(pathOf(key), found, expected);
}

const Json* FieldReader::find(std::string_view key, Need need) {
    known_.push_back(key);
    if (failed()) return nullptr;
    if (const Json* value = object_->find(key)) return value;
    if (need == Need::Required) fail({}, "no \"" + std::string(key) + "\"", "one");
    return nullptr;
}

const Json* FieldReader::findArray(std::string_view key, std::size_t most, Need need) {
    const Json* found = find(key, need);
    if (found == nullptr) return nullptr;
    if (!found->isArray()) {
        fail(key, describeJson(*found), "an array");
        return nullptr;
    }
    if (found->size() <= most) return found;
    fail(key, describeJson(*found), "at most " + std::to_string(most) + " items");
    return nullptr;
}

void FieldReader::finish() {
    if (failed()) return;
    for (const auto& [unknown, value] : object_->members()) {
        if (std::find(known_.begin(), known_.end(), unknown) != known_.end()) continue;
        std::string names;
        for (std::string_view key : known_) {
            if (names.size() > 300) break;
            names += (names.empty() ? "" : ", ") + std::string(key);
        }
        return fail({}, "the unknown key \"" + unknown.substr(0, 80) + "\"", "one of " + names);
    }
}

void FieldReader::text(std::string_view key, std::string& value, const char*, Need need, std::string_view) {
    const Json* found = find(key, need);
    if (found == nullptr) return;
    if (!found->isText()) return fail(key, describeJson(*found), "a text");
    value = found->text();
}

bool FieldReader::readNumber(const Json& value, const NumberRange& range, double& number) {
    if (!value.isNumber()) return false;
    const double read = value.number();
    if (!(read >= range.minimum && read <= range.maximum)) return false;
    if (range.whole && read != std::floor(read)) return false;
    number = read;
    return true;
}

void FieldReader::failNumber(std::string_view key, const Json& found, const NumberRange& range) {
    fail(key, describeJson(found), expectation(range));
}

void FieldReader::number(std::string_view key, double& value, const NumberRange& range, std::string_view,
                         Need need) {
    const Json* found = find(key, need);
    if (found != nullptr && !readNumber(*found, range, value)) failNumber(key, *found, range);
}

void FieldReader::flag(std::string_view key, bool& value, const char*) {
    const Json* found = find(key);
    if (found == nullptr) return;
    if (!found->isBoolean()) return fail(key, describeJson(*found), "true or false");
    value = found->boolean();
}

void FieldReader::colour(std::string_view key, std::optional<std::uint32_t>& value, const char*) {
    const Json* found = find(key);
    if (found == nullptr) return;
    const auto read = found->isText() ? parseColour(found->text()) : std::nullopt;
    if (!read) return fail(key, describeJson(*found), "a colour as \"#rrggbb\"");
    value = read;
}

bool FieldReader::readPoint(const Json& value, const std::string& path, Vec2& point) {
    if (value.isArray() && value.size() == 2 && value[0].isNumber() && value[1].isNumber()) {
        point = {value[0].number(), value[1].number()};
        if (std::fabs(point.x) <= 1e6 && std::fabs(point.y) <= 1e6) return true;
        failAt(path, compactJson(value), "coordinates in [-1e6, 1e6] m");
        return false;
    }
    failAt(path, describeJson(value), "a point [x, y]");
    return false;
}

void FieldReader::point(std::string_view key, Vec2& value, const char*, Need need) {
    if (const Json* found = find(key, need)) readPoint(*found, pathOf(key), value);
}

void FieldReader::points(std::string_view key, std::vector<Vec2>& value, std::size_t least, std::size_t most,
                         const char*, Need need) {
    const Json* found = findArray(key, most, need);
    if (found == nullptr) return;
    if (found->size() < least) {
        return fail(key, describeJson(*found), "at least " + std::to_string(least) + " points");
    }
    value.resize(found->size());
    for (std::size_t i = 0; i < value.size(); ++i) {
        const Json& item = (*found)[i];
        const bool good = item.isArray() && item.size() == 2 && item[0].isNumber() && item[1].isNumber();
        if (!readPoint(item, good ? pathOf(key) : pathOf(key) + "[" + std::to_string(i) + "]", value[i]))
            return;
    }
}

void FieldReader::choice(std::string_view key, std::string& value, const std::vector<std::string>& names,
                         const char*, Need need) {
    const Json* found = find(key, need);
    if (found == nullptr) return;
    if (found->isText() && std::find(names.begin(), names.end(), found->text()) != names.end()) {
        value = found->text();
        return;
    }
    fail(key, describeJson(*found), listNames(names));
}

void FieldReader::nameOrIndex(std::string_view key, std::int32_t& value,
                              const std::vector<std::string>& names, const char*, Need need) {
    const Json* found = find(key, need);
    if (found == nullptr) return;
    if (found->isText()) {
        const auto name = std::find(names.begin(), names.end(), found->text());
        if (name == names.end()) return fail(key, describeJson(*found), listNames(names));
        value = static_cast<std::int32_t>(name - names.begin());
        return;
    }
    const double most = names.empty() ? 999.0 : static_cast<double>(names.size()) - 1.0;
    const NumberRange range{0.0, most, "1", true};
    double number = 0.0;
    if (!readNumber(*found, range, number)) return failNumber(key, *found, range);
    value = static_cast<std::int32_t>(number);
}

}  // namespace muster
