#include "files/export/gltf_people.h"

#include <cmath>
#include <cstdio>

namespace muster {
namespace {

constexpr float kShort = 32767.0f;  // The 16-bit integer that stands for 1.

// The values of a character in a frame: rotations of all joints, translation of hips and root, rotation of
// the root.
constexpr std::size_t kHips = kJointCount, kRootPosition = kHips + 1, kRootRotation = kHips + 2;
constexpr std::size_t kValues = kHips + 3;

constexpr std::array<std::uint32_t, kValues> widths() {
    std::array<std::uint32_t, kValues> list{};
    list.fill(4 * sizeof(std::int16_t));
    list[kHips] = list[kRootPosition] = 3 * sizeof(float);
    list[kRootRotation] = 4 * sizeof(float);
    return list;
}
constexpr std::array<std::uint32_t, kValues> kWidths = widths();

void putFloats(std::string& record, std::span<const float> values) {
    record.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

void putShorts(std::string& record, Quat q) {
    const auto whole = [](float v) { return static_cast<std::int16_t>(std::lround(v * kShort)); };
    const std::array<std::int16_t, 4> values{whole(q.x), whole(q.y), whole(q.z), whole(q.w)};
    record.append(reinterpret_cast<const char*>(values.data()), sizeof(values));
}

/// The same rotation with the sign nearer to the previous one, so that interpolation takes the short arc.
Quat beside(Quat q, Quat& before) {
    q = normalized(q);
    return before = dot(q, before) < 0.0f ? -q : q;
}

Vec3 placeOf(const ExportCharacter& c) {
    return {static_cast<float>(c.position.x), static_cast<float>(c.position.y), 0.0f};
}

std::string nameOf(std::uint32_t id) {
    char name[40];
    std::snprintf(name, sizeof(name), "character-%04u", id);
    return name;
}

std::string node(const std::string& name, const std::string& rest, std::span<const std::uint32_t> children) {
    std::string text = "{\"name\":" + jsonText(name) + rest;
    if (!children.empty()) text += ",\"children\":" + jsonNumbers(children);
    return text + "}";
}

}  // namespace

std::uint64_t GltfPeople::trackBytes(std::size_t frames) {
    std::uint64_t bytes = 0;
    for (const std::uint32_t width : kWidths) bytes += width;
    return bytes * frames;
}

Status GltfPeople::frame(const ExportFrame& frame) {
    for (const ExportCharacter& character : frame.characters) {
        const auto found = people_.find(character.id);
        Person* person = found != people_.end() ? &found->second : nullptr;
        if (person == nullptr) {
            const auto begun = begin(character, frame);
            if (!begun.ok()) return begun.status();
            person = *begun;
        }
        if (person->seen != frame.index || person->changes.empty()) {
            if (!person->changes.empty()) person->changes.push_back(person->seen);
            person->changes.push_back(frame.index);
        }
        person->seen = frame.index + 1;
        makeRecord(character, *person);
        if (Status s = person->track.fill(frame.index, record_); !s.ok()) return s;
        if (Status s = person->track.add(record_); !s.ok()) return s;
    }
    return {};
}

Result<GltfPeople::Person*> GltfPeople::begin(const ExportCharacter& character, const ExportFrame& frame) {
    const std::uint32_t root = document_.nodes.size();
    const CharacterLook look = characterLook(character.id, character.group, *frame.world);
    if (Status s = addNodes(character, look, root); !s.ok()) return s;
    Person person(GltfTrack(buffer_, frames_, kWidths));
    person.root = root;
    person.size = character.size;
    return &people_.emplace(character.id, std::move(person)).first->second;
}

Status GltfPeople::addNodes(const ExportCharacter& character, const CharacterLook& look, std::uint32_t root) {
    const auto mesh = meshes_.body(look);
    if (!mesh.ok()) return mesh.status();
    const auto binds = meshes_.inverseBinds();
    if (!binds.ok()) return binds.status();
    const auto& bones = skeleton();
    const std::string name = nameOf(character.id);
    const std::array<std::uint32_t, 1> hips{root + 1};
    const auto turn = gltfAxes(yawTurn(static_cast<double>(character.yaw)));
    const Vec3 scale{character.size, character.size, character.size};
    document_.nodes.add(node(name,
                             ",\"translation\":" + jsonNumbers(gltfAxes(placeOf(character))) +
                                 ",\"rotation\":" + jsonNumbers(turn) + ",\"scale\":" + jsonNumbers(scale),
                             hips));
    std::vector<std::uint32_t> joints;
    for (std::size_t j = 0; j < kJointCount; ++j) {
        std::vector<std::uint32_t> children;
        for (std::size_t k = j + 1; k < kJointCount; ++k)
            if (bones[k].parent == static_cast<std::int32_t>(j))
                children.push_back(root + 1 + static_cast<std::uint32_t>(k));
        document_.nodes.add(
            node(bones[j].name, ",\"translation\":" + jsonNumbers(gltfAxes(bones[j].offset)), children));
        joints.push_back(root + 1 + static_cast<std::uint32_t>(j));
    }
    const std::uint32_t skin = document_.skins.add(
        "{\"name\":" + jsonText(name) + ",\"inverseBindMatrices\":" + std::to_string(*binds) +
        ",\"skeleton\":" + std::to_string(root + 1) + ",\"joints\":" + jsonNumbers(joints) + "}");
    const std::uint32_t body = document_.nodes.add(
        node(name + "-body", ",\"mesh\":" + std::to_string(*mesh) + ",\"skin\":" + std::to_string(skin), {}));
    document_.roots.add(std::to_string(root));
    document_.roots.add(std::to_string(body));
    return {};
}

void GltfPeople::makeRecord(const ExportCharacter& character, Person& person) {
    record_.clear();
    for (std::size_t j = 0; j < kJointCount; ++j)
        putShorts(record_, beside(gltfAxes(character.pose->rotation[j]), person.before[j]));
    const Vec3 hips = gltfAxes(character.pose->hips), root = gltfAxes(placeOf(character));
    putFloats(record_, std::array{hips.x, hips.y, hips.z});
    putFloats(record_, std::array{root.x, root.y, root.z});
    const Quat turn = beside(gltfAxes(yawTurn(static_cast<double>(character.yaw))),
                             person.before[kJointCount]);
    putFloats(record_, std::array{turn.x, turn.y, turn.z, turn.w});
}

Status GltfPeople::finish(std::uint32_t times, double fps) {
    for (auto& [id, person] : people_) {
        if (Status s = person.track.fill(frames_, {}); !s.ok()) return s;
        if (Status s = person.track.flush(); !s.ok()) return s;
        animate(person, times);
        if (person.seen < frames_) person.changes.push_back(person.seen);
        if (person.changes != std::vector<std::size_t>{0}) {
            if (Status s = hide(person, fps); !s.ok()) return s;
        }
    }
    return {};
}

void GltfPeople::animate(const Person& person, std::uint32_t times) {
    const std::uint32_t view = document_.addView(person.track.begin(), person.track.bytes(),
                                                 GltfTarget::None);
    const GltfValues turns{GltfNumber::Short, "VEC4", frames_, true};
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const std::uint32_t values = document_.addAccessor(view, person.track.offset(j), turns);
        document_.animate(person.root + 1 + static_cast<std::uint32_t>(j), "rotation", times, values);
    }
    const auto floats = [&](std::uint32_t of, const char* path, std::size_t value, const char* type) {
        const GltfValues values{GltfNumber::Float, type, frames_};
        document_.animate(of, path, times, document_.addAccessor(view, person.track.offset(value), values));
    };
    floats(person.root + 1, "translation", kHips, "VEC3");
    floats(person.root, "translation", kRootPosition, "VEC3");
    floats(person.root, "rotation", kRootRotation, "VEC4");
}

Status GltfPeople::hide(const Person& person, double fps) {
    std::vector<float> times, sizes;
    const auto at = [&](std::size_t frame, bool there) {
        times.push_back(static_cast<float>(static_cast<double>(frame) / fps));
        sizes.insert(sizes.end(), 3, there ? person.size : 0.0f);
    };
    if (person.changes.front() > 0) at(0, false);
    for (std::size_t k = 0; k < person.changes.size(); ++k) at(person.changes[k], k % 2 == 0);
    std::string bytes;
    putFloats(bytes, times);
    putFloats(bytes, sizes);
    std::uint64_t offset = 0;
    if (Status s = buffer_.append(bytes, offset); !s.ok()) return s;
    const std::uint32_t view = document_.addView(offset, bytes.size(), GltfTarget::None);
    GltfValues keys{GltfNumber::Float, "SCALAR", times.size()};
    keys.least = jsonNumbers(std::span<const float>(times).first(1));
    keys.most = jsonNumbers(std::span<const float>(times).last(1));
    const std::uint32_t when = document_.addAccessor(view, 0, keys);
    const GltfValues values{GltfNumber::Float, "VEC3", times.size()};
    const std::uint32_t what = document_.addAccessor(view, times.size() * sizeof(float), values);
    document_.animate(person.root, "scale", when, what, true);
    return {};
}

}  // namespace muster
