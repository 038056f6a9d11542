#include "files/take/take_format.h"

#include <algorithm>
#include <cmath>

#include "base/easing.h"
#include "files/take/about_words.h"
#include "files/take/take_edits.h"
#include "json/json.h"

namespace muster {
namespace {

constexpr double kSlowest = 0.1, kFastest = 8.0;  // [seconds of the take per second]

Status checkPiece(const SpeedPiece& piece, double earliest, const std::string& where) {
    if (!std::isfinite(piece.from) || piece.from < earliest)
        return invalidArgument(where + ".from: found " + numberText(piece.from) + ", expected " +
                               numberText(earliest) + " or later");
    if (!std::isfinite(piece.to) || piece.to <= piece.from)
        return invalidArgument(where + ".to: found " + numberText(piece.to) + ", expected later than from");
    if (!(piece.speed >= kSlowest && piece.speed <= kFastest))
        return invalidArgument(where + ".speed: found " + numberText(piece.speed) + ", expected 0.1 to 8");
    if (!std::isfinite(piece.ease) || piece.ease < 0.0)
        return invalidArgument(where + ".ease: found " + numberText(piece.ease) + ", expected 0 or more");
    return {};
}

Status readStep(const Json& object, const char* key, std::uint32_t& step) {
    const Json* found = object.find(key);
    if (found == nullptr || found->isNull()) return {};
    const bool fits = found->isWhole() && found->number() >= 0.0 && found->number() <= double{kTakeEnd};
    if (!fits) return wrongKind(key, *found, "a number of steps");
    step = found->whole<std::uint32_t>();
    return {};
}

Status readSpeeds(const Json& list, std::vector<SpeedPiece>& speeds) {
    if (!list.isArray()) return wrongKind("speeds", list, "an array");
    speeds.clear();
    for (const Json& entry : list.elements()) {
        if (!entry.isObject()) return wrongKind("speeds", entry, "objects in it");
        SpeedPiece piece;
        const Status status = readNumbers(
            entry,
            {{"from", &piece.from}, {"to", &piece.to}, {"speed", &piece.speed}, {"ease", &piece.ease}});
        if (!status.ok()) return status.within("speeds");
        speeds.push_back(piece);
    }
    return {};
}

Status checkKey(const CameraKey& key, bool later, const std::string& where) {
    if (!later)
        return invalidArgument(where + ".step: found " + std::to_string(key.step) +
                               ", expected more than in the key before");
    for (const double value : {key.x, key.y, key.turn, key.pitch})
        if (!std::isfinite(value)) return invalidArgument(where + ": found a number that is not finite");
    if (!std::isfinite(key.distance) || key.distance <= 0.0)
        return invalidArgument(where + ".distance: found " + numberText(key.distance) + ", expected above 0");
    return {};
}

Status readCamera(const Json& list, std::vector<CameraKey>& camera) {
    if (!list.isArray()) return wrongKind("camera", list, "an array");
    camera.clear();
    for (const Json& entry : list.elements()) {
        if (!entry.isObject()) return wrongKind("camera", entry, "objects in it");
        CameraKey key;
        Status status = readStep(entry, "step", key.step);
        if (status.ok())
            status = readNumbers(entry, {{"x", &key.x},
                                         {"y", &key.y},
                                         {"distance", &key.distance},
                                         {"turn", &key.turn},
                                         {"pitch", &key.pitch}});
        const Json* cut = entry.find("cut");
        if (status.ok() && cut != nullptr && !cut->isBoolean())
            status = wrongKind("cut", *cut, "true or false");
        if (!status.ok()) return status.within("camera");
        key.cut = cut != nullptr && cut->boolean();
        camera.push_back(key);
    }
    return {};
}

}  // namespace

std::uint32_t TakeAbout::firstStep(std::uint32_t steps) const {
    return std::min(from, lastStep(steps) - std::min(lastStep(steps), 1u));
}

std::uint32_t TakeAbout::lastStep(std::uint32_t steps) const {
    return std::max(std::min(to, steps), std::min(steps, 1u));
}

double TakeAbout::speedAt(double seconds) const {
    for (const SpeedPiece& piece : speeds) {
        if (seconds < piece.from || seconds >= piece.to) continue;
        const double ease = std::min(piece.ease, 0.5 * (piece.to - piece.from));
        if (ease <= 0.0) return piece.speed;
        const double inside = std::min(seconds - piece.from, piece.to - seconds);
        return 1.0 + (piece.speed - 1.0) * smoothStep(inside / ease);
    }
    return 1.0;
}

Status TakeAbout::check() const {
    if (title.size() > kMaxTitleBytes)
        return invalidArgument("title: found " + std::to_string(title.size()) + " bytes, expected at most " +
                               std::to_string(kMaxTitleBytes));
    const auto control = [](char c) { return static_cast<unsigned char>(c) < 32; };
    if (std::any_of(title.begin(), title.end(), control))
        return invalidArgument("title: found a control character, expected plain text");
    if (to <= from)
        return invalidArgument("to: found " + std::to_string(to) + ", expected more than " +
                               std::to_string(from));
    if (speeds.size() > kMaxSpeedPieces)
        return invalidArgument("speeds: found " + std::to_string(speeds.size()) + ", expected at most " +
                               std::to_string(kMaxSpeedPieces));
    double earliest = 0.0;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        const Status s = checkPiece(speeds[i], earliest, "speeds[" + std::to_string(i) + "]");
        if (!s.ok()) return s;
        earliest = speeds[i].to;
    }
    if (camera.size() > kMaxCameraKeys)
        return invalidArgument("camera: found " + std::to_string(camera.size()) + ", expected at most " +
                               std::to_string(kMaxCameraKeys));
    for (std::size_t i = 0; i < camera.size(); ++i) {
        const bool later = i == 0 || camera[i].step > camera[i - 1].step;
        const Status s = checkKey(camera[i], later, "camera[" + std::to_string(i) + "]");
        if (!s.ok()) return s;
    }
    return checkEdits(edits);
}

std::string writeTakeAbout(const TakeAbout& about) {
    Json value = Json::object();
    if (!about.title.empty()) value["title"] = about.title;
    if (about.from != 0) value["from"] = about.from;
    if (about.to != kTakeEnd) value["to"] = about.to;
    for (const SpeedPiece& piece : about.speeds)
        value["speeds"].push(
            {{"from", piece.from}, {"to", piece.to}, {"speed", piece.speed}, {"ease", piece.ease}});
    for (const CameraKey& key : about.camera) {
        Json entry = Json::object();
        entry["step"] = key.step;
        for (const auto& [name, number] : {std::pair{"x", key.x},
                                           {"y", key.y},
                                           {"distance", key.distance},
                                           {"turn", key.turn},
                                           {"pitch", key.pitch}})
            entry[name] = number;
        if (key.cut) entry["cut"] = true;
        value["camera"].push(std::move(entry));
    }
    if (!about.edits.empty()) value["edits"] = describeEdits(about.edits);
    return compactJson(value);
}

Result<TakeAbout> readTakeAbout(std::string_view text, const std::string& sourceName) {
    const auto value = parseJson(text, sourceName);
    if (!value.ok()) return value.status();
    if (!value->isObject())
        return Status(StatusCode::ParseError,
                      sourceName + ": found " + describeJson(*value) + ", expected an object");
    TakeAbout about;
    if (const Json* title = value->find("title")) {
        if (!title->isText()) return wrongKind("title", *title, "a text").within(sourceName);
        about.title = title->text();
    }
    Status status = readStep(*value, "from", about.from);
    if (status.ok()) status = readStep(*value, "to", about.to);
    if (const Json* speeds = value->find("speeds"); status.ok() && speeds != nullptr)
        status = readSpeeds(*speeds, about.speeds);
    if (const Json* camera = value->find("camera"); status.ok() && camera != nullptr)
        status = readCamera(*camera, about.camera);
    if (const Json* edits = value->find("edits"); status.ok() && edits != nullptr)
        status = readEdits(*edits, about.edits);
    if (status.ok()) status = about.check();
    if (!status.ok()) return status.within(sourceName);
    return about;
}

}  // namespace muster
