#include "files/scenario/fields.h"

#include "base/appearance_text.h"

namespace muster {

void FieldWriter::text(std::string_view key, const std::string& value, const char*, Need need,
                       std::string_view fallback) {
    if (!value.empty() || !fallback.empty() || need == Need::Required) set(key, value);
}

void FieldWriter::number(std::string_view key, double value, const NumberRange& range, std::string_view,
                         Need) {
    if (range.whole) return set(key, static_cast<std::int64_t>(value));
    set(key, value);
}

void FieldWriter::optionalNumber(std::string_view key, double value, const NumberRange&, const char*) {
    if (value >= 0.0) set(key, value);
}

void FieldWriter::flag(std::string_view key, bool value, const char*) {
    set(key, value);
}

void FieldWriter::colour(std::string_view key, const std::optional<std::uint32_t>& value, const char*) {
    if (value) set(key, colourText(*value));
}

void FieldWriter::point(std::string_view key, Vec2 value, const char*, Need) {
    set(key, Json::array({value.x, value.y}));
}

void FieldWriter::points(std::string_view key, const std::vector<Vec2>& value, std::size_t, std::size_t,
                         const char*, Need need) {
    if (value.empty() && need == Need::Optional) return;
    Json array = Json::array();
    for (Vec2 p : value) array.push(Json::array({p.x, p.y}));
    set(key, std::move(array));
}

void FieldWriter::choice(std::string_view key, const std::string& value, const std::vector<std::string>&,
                         const char*, Need) {
    if (!value.empty()) set(key, value);
}

void FieldWriter::nameOrIndex(std::string_view key, std::int32_t value, const std::vector<std::string>& names,
                              const char*, Need) {
    const auto index = static_cast<std::size_t>(value);
    if (index < names.size()) return set(key, names[index]);
    set(key, value);
}

}  // namespace muster
