#include "json/json.h"

#include <algorithm>
#include <utility>

#include "muster/assert.h"

namespace muster {

Json::Json(std::string text) : kind_(Kind::Text) {
    data_.text = new std::string(std::move(text));
}

Json::Json(std::string_view text) : Json(std::string(text)) {}

Json::Json(const char* text) : Json(std::string(text)) {}

Json::Json(std::initializer_list<Member> members) : kind_(Kind::Object) {
    data_.object = new std::vector<Member>(members);
}

Json::Json(const Json& other) : kind_(other.kind_), data_(other.data_) {
    if (kind_ == Kind::Text) data_.text = new std::string(*other.data_.text);
    if (kind_ == Kind::Array) data_.array = new std::vector<Json>(*other.data_.array);
    if (kind_ == Kind::Object) data_.object = new std::vector<Member>(*other.data_.object);
}

Json::Json(Json&& other) noexcept : kind_(std::exchange(other.kind_, Kind::Null)), data_(other.data_) {}

Json& Json::operator=(Json other) noexcept {
    std::swap(kind_, other.kind_);
    std::swap(data_, other.data_);
    return *this;
}

Json::~Json() {
    if (kind_ == Kind::Text) delete data_.text;
    if (kind_ == Kind::Array) delete data_.array;
    if (kind_ == Kind::Object) delete data_.object;
}

Json Json::array(std::initializer_list<Json> list) {
    Json json;
    json.kind_ = Kind::Array;
    json.data_.array = new std::vector<Json>(list);
    return json;
}

bool Json::boolean() const {
    MUSTER_ASSERT(isBoolean());
    return data_.boolean;
}

double Json::number() const {
    MUSTER_ASSERT(isNumber());
    if (kind_ == Kind::Integer) return static_cast<double>(data_.integer);
    return kind_ == Kind::Unsigned ? static_cast<double>(data_.natural) : data_.real;
}

const std::string& Json::text() const {
    MUSTER_ASSERT(isText());
    return *data_.text;
}

std::size_t Json::size() const {
    if (kind_ == Kind::Array) return data_.array->size();
    if (kind_ == Kind::Object) return data_.object->size();
    return isNull() ? 0 : 1;
}

const std::vector<Json>& Json::elements() const {
    MUSTER_ASSERT(isArray());
    return *data_.array;
}

Json& Json::operator[](std::size_t index) {
    MUSTER_ASSERT(isArray());
    return (*data_.array)[index];
}

Json& Json::push(Json value) {
    if (isNull()) *this = array();
    MUSTER_ASSERT(isArray());
    return data_.array->emplace_back(std::move(value));
}

const std::vector<Json::Member>& Json::members() const {
    MUSTER_ASSERT(isObject());
    return *data_.object;
}

const Json* Json::find(std::string_view key) const {
    if (!isObject()) return nullptr;
    for (const Member& member : *data_.object)
        if (member.key == key) return &member.value;
    return nullptr;
}

Json& Json::operator[](std::string_view key) {
    if (isNull()) *this = object();
    MUSTER_ASSERT(isObject());
    for (Member& member : *data_.object)
        if (member.key == key) return member.value;
    return data_.object->emplace_back(Member{std::string(key), {}}).value;
}

void Json::erase(std::string_view key) {
    MUSTER_ASSERT(isObject());
    std::erase_if(*data_.object, [&](const Member& member) { return member.key == key; });
}

}  // namespace muster
