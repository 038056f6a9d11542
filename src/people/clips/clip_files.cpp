#include "people/clips/clip_files.h"

#include <cmath>
#include <filesystem>

#include "base/appearance_text.h"
#include "base/text_file.h"
#include "json/json.h"
#include "muster/clip.h"
#include "people/clips/motion_facts.h"
#include "people/clips/retarget.h"

namespace muster {
namespace {

constexpr const char* kFormat = "muster-clips";
constexpr std::size_t kMostClips = 1000;

bool isFileName(const std::string& name) {
    if (name.empty() || name.size() > 80 || name[0] == '.') return false;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '_' || c == '.';
        if (!plain) return false;
    }
    return true;
}

Json contactJson(const Contact& contact) {
    return {{"limb", limbName(contact.limb)},
            {"begin_s", contact.begin},
            {"end_s", contact.end},
            {"anchor_m", Json::array({contact.anchor.x, contact.anchor.y, contact.anchor.z})}};
}

Json clipJson(const Clip& clip, double run) {
    const MotionFacts facts = factsOf(clip);
    Json json = {{"clip", clip.name},
                 {"motion", clip.motion},
                 {"file", clip.name + ".bvh"},
                 {"speed_mps", facts.speed},
                 {"ratio", speedRatio(facts.speed, run)},
                 {"duration_s", facts.duration},
                 {"length_m", facts.length},
                 {"cyclic", clip.cyclic},
                 {"entry_phase", clip.entryPhase},
                 {"exit_phase", clip.exitPhase}};
    json["obstacle"] = {{"height_m", clip.obstacle.height}, {"thickness_m", clip.obstacle.thickness}};
    if (clip.set) json["set"] = kMotionSetWords[static_cast<std::size_t>(*clip.set)];
    json["contacts"] = Json::array();
    for (const Contact& contact : clip.contacts) json["contacts"].push(contactJson(contact));
    return json;
}

/// Reads the fields of one JSON object and remembers the first error.
class FieldsOf {
public:
    explicit FieldsOf(const Json& json, std::string path) : json_(json), path_(std::move(path)) {
        if (!json.isObject()) fail("", "an object");
    }

    double number(const char* key, double low, double high) {
        const Json* found = find(key);
        const double value = found != nullptr && found->isNumber() ? found->number() : std::nan("");
        if (!(value >= low && value <= high)) fail(key, "a number in range");
        return value;
    }
    std::string text(const char* key) {
        const Json* found = find(key);
        if (found != nullptr && found->isText()) return found->text();
        fail(key, "text");
        return {};
    }
    bool flag(const char* key) {
        const Json* found = find(key);
        if (found != nullptr && found->isBoolean()) return found->boolean();
        fail(key, "true or false");
        return false;
    }
    /// The list of that name; empty on an error.
    const Json& list(const char* key, std::size_t most) {
        static const Json kNone = Json::array();
        const Json* found = find(key);
        if (found != nullptr && found->isArray() && found->size() <= most) return *found;
        fail(key, "a list");
        return kNone;
    }
    /// The value of that name, with an error if it is not an object.
    const Json& object(const char* key) {
        static const Json kNone = Json::object();
        const Json* found = find(key);
        return found != nullptr ? *found : kNone;
    }
    /// The motion set of that name; none where it is left out.
    std::optional<MotionSet> motionSet(const char* key) {
        if (find(key) == nullptr) return std::nullopt;
        const std::string word = text(key);
        for (std::size_t k = 0; k < kCountOf<MotionSet>; ++k)
            if (word == kMotionSetWords[k]) return static_cast<MotionSet>(k);
        fail(key, "\"march\" or \"weary\"");
        return std::nullopt;
    }
    void fail(const std::string& key, const std::string& expected) {
        if (status_.ok())
            status_ = {StatusCode::ParseError,
                       path_ + (key.empty() ? "" : "." + key) + ": expected " + expected};
    }
    void fail(const Status& status) {
        if (status_.ok()) status_ = status;
    }
    const Status& status() const { return status_; }
    const std::string& path() const { return path_; }

private:
    const Json* find(const char* key) const { return json_.find(key); }

    const Json& json_;
    std::string path_;
    Status status_;
};

Contact contactOf(const Json& json, FieldsOf& clip, std::size_t i) {
    FieldsOf fields(json, clip.path() + ".contacts[" + std::to_string(i) + "]");
    Contact contact;
    const std::string limb = fields.text("limb");
    std::size_t l = 0;
    while (l < kLimbCount && limb != limbName(static_cast<Limb>(l))) ++l;
    if (l == kLimbCount) fields.fail("limb", "a limb such as \"left foot\"");
    contact.limb = static_cast<Limb>(l);
    contact.begin = fields.number("begin_s", 0.0, 1e6);
    contact.end = fields.number("end_s", 0.0, 1e6);
    const Json& anchor = fields.list("anchor_m", 3);
    float xyz[3] = {};
    for (std::size_t k = 0; k < 3; ++k) {
        if (k < anchor.size() && anchor[k].isNumber())
            xyz[k] = static_cast<float>(anchor[k].number());
        else
            fields.fail("anchor_m", "three numbers");
    }
    contact.anchor = {xyz[0], xyz[1], xyz[2]};
    clip.fail(fields.status());
    return contact;
}

Result<Clip> clipOf(const Json& json, std::size_t i, const std::string& folder) {
    FieldsOf fields(json, "$.clips[" + std::to_string(i) + "]");
    const RetargetOptions options{fields.text("clip"), fields.text("motion"), fields.flag("cyclic")};
    const std::string file = fields.text("file");
    if (!isFileName(options.name)) fields.fail("clip", "letters, digits, \"-\", \"_\" and \".\"");
    if (!isFileName(file)) fields.fail("file", "the name of a file beside the list");
    const double entry = fields.number("entry_phase", 0.0, 1.0), exit = fields.number("exit_phase", 0.0, 1.0);
    FieldsOf obstacle(fields.object("obstacle"), fields.path() + ".obstacle");
    const double height = obstacle.number("height_m", 0.0, 100.0),
                 thickness = obstacle.number("thickness_m", 0.0, 100.0);
    fields.fail(obstacle.status());
    const std::optional<MotionSet> set = fields.motionSet("set");
    std::vector<Contact> contacts;
    for (const Json& contact : fields.list("contacts", 10000).elements())
        contacts.push_back(contactOf(contact, fields, contacts.size()));
    if (!fields.status().ok()) return fields.status();
    const auto motion = readBvh(folder + "/" + file);
    if (!motion.ok()) return motion.status();
    auto clip = retarget(*motion, options);
    if (!clip.ok()) return clip.status().within(folder + "/" + file);
    clip->entryPhase = entry;
    clip->exitPhase = exit;
    clip->obstacle = {static_cast<float>(height), static_cast<float>(thickness)};
    clip->contacts = std::move(contacts);
    clip->set = set;
    if (Status s = validate(*clip); !s.ok()) return s;
    return clip;
}

}  // namespace

Status writeClips(const ClipLibrary& library, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return {StatusCode::IoError, folder + ": cannot be made: " + error.message()};
    const Clip* run = library.find("run");
    Json json = {{"format", kFormat}, {"version", 1}, {"run_mps", run != nullptr ? run->speed() : kUsualRun}};
    json["clips"] = Json::array();
    for (const Clip& clip : library.clips) {
        if (!isFileName(clip.name))
            return invalidArgument("clip \"" + clip.name.substr(0, 40) + "\": its name is no file name");
        if (Status s = writeTextFile(folder + "/" + clip.name + ".bvh", bvhText(clip)); !s.ok()) return s;
        json["clips"].push(clipJson(clip, json["run_mps"].number()));
    }
    return writeTextFile(folder + "/" + kClipList, indentedJson(json, 1) + "\n");
}

Result<ClipLibrary> loadClips(const std::string& folder) {
    const std::string path = folder + "/" + kClipList;
    const auto text = readTextFile(path);
    if (!text.ok()) return text.status();
    const auto json = parseJson(*text, path);
    if (!json.ok()) return Status(StatusCode::ParseError, path + ": is not JSON");
    FieldsOf fields(*json, "$");
    if (fields.text("format") != kFormat) fields.fail("format", std::string("\"") + kFormat + "\"");
    fields.number("version", 1.0, 1.0);
    const Json& list = fields.list("clips", kMostClips);
    if (!fields.status().ok()) return fields.status().within(path);
    ClipLibrary library;
    for (std::size_t i = 0; i < list.size(); ++i) {
        auto clip = clipOf(list[i], i, folder);
        if (!clip.ok()) return clip.status().within(path);
        if (library.find(clip->name) != nullptr)
            return Status(StatusCode::ParseError, path + ": $.clips[" + std::to_string(i) +
                                                      "].clip: found \"" + clip->name + "\" a second time");
        library.clips.push_back(std::move(*clip));
    }
    return library;
}

}  // namespace muster
