#include "files/export/formats.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <vector>

#include "muster/clip.h"
#include "people/clips/bvh_text.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferBytes = 1u << 15;  // Each character's text is buffered up to this size.

/// The files of all characters. None stays open, because there may be more than a process can open.
class BvhExporter : public Exporter {
public:
    explicit BvhExporter(std::string folder) : folder_(std::move(folder)) {}
    ~BvhExporter() override { removeParts(); }

    Status begin(const ExportInfo& info) override {
        info_ = info;
        std::error_code error;
        madeFolder_ = fs::create_directory(folder_, error);
        if (!fs::is_directory(folder_, error))
            return cannotWrite(folder_, "it is no folder and cannot be made one");
        return {};
    }

    Status frame(const ExportFrame& frame) override {
        for (const ExportCharacter& character : frame.characters) {
            auto found = tracks_.find(character.id);
            if (found == tracks_.end()) found = tracks_.emplace(character.id, Track(character.size)).first;
            Track& track = found->second;
            if (track.frames == 0) begin(track);
            track.line.clear();
            const Travel root{static_cast<float>(character.position.x),
                              static_cast<float>(character.position.y), character.yaw};
            track.writer.append(root, *character.pose, track.line);
            // While the character is missing, it stands in its present pose.
            if (Status s = fill(character.id, track, frame.index + 1); !s.ok()) return s;
        }
        return {};
    }

    Status finish() override {
        for (auto& [id, track] : tracks_) {
            if (Status s = fill(id, track, info_.frames); !s.ok()) return s;
            if (Status s = flush(id, track); !s.ok()) return s;
        }
        for (const auto& [id, track] : tracks_) {
            std::error_code error;
            fs::rename(partOf(id), fileOf(id), error);
            if (error) return cannotWrite(fileOf(id), error.message());
        }
        tracks_.clear();
        madeFolder_ = false;
        return {};
    }

private:
    struct Track {
        explicit Track(float size) : writer(size) {}
        BvhFrameWriter writer;
        std::string text;        ///< Text not yet written.
        std::string line;        ///< The last frame's line.
        std::size_t frames = 0;  ///< Number of frames in text and file.
        bool begun = false;      ///< True when the file exists.
    };

    static Status cannotWrite(const std::string& path, const std::string& why) {
        return {StatusCode::IoError, path + ": cannot be written: " + why};
    }

    std::string fileOf(std::uint32_t id) const {
        char name[40];
        std::snprintf(name, sizeof(name), "/character-%04u.bvh", id);
        return folder_ + name;
    }
    std::string partOf(std::uint32_t id) const { return fileOf(id) + ".part"; }

    void begin(Track& track) const {
        track.text = track.writer.hierarchy() + BvhFrameWriter::motionHead(info_.frames, info_.fps);
    }

    Status fill(std::uint32_t id, Track& track, std::size_t frames) {
        for (; track.frames < frames; ++track.frames) {
            track.text += track.line;
            if (track.text.size() < kBufferBytes) continue;
            if (Status s = flush(id, track); !s.ok()) return s;
        }
        return {};
    }

    Status flush(std::uint32_t id, Track& track) {
        const std::string path = partOf(id);
        std::FILE* file = std::fopen(path.c_str(), track.begun ? "ab" : "wb");
        if (file == nullptr) return cannotWrite(path, std::strerror(errno));
        track.begun = true;
        const bool wrote = std::fwrite(track.text.data(), 1, track.text.size(), file) == track.text.size();
        const bool closed = std::fclose(file) == 0;
        track.text.clear();
        return wrote && closed ? Status() : cannotWrite(path, std::strerror(errno));
    }

    void removeParts() {
        std::error_code ignored;
        for (const auto& [id, track] : tracks_)
            if (track.begun) fs::remove(partOf(id), ignored);
        if (madeFolder_) fs::remove(folder_, ignored);
    }

    std::string folder_;
    ExportInfo info_;
    std::map<std::uint32_t, Track> tracks_;
    bool madeFolder_ = false;
};

}  // namespace

std::unique_ptr<Exporter> makeBvhExporter(const std::string& folder) {
    return std::make_unique<BvhExporter>(folder);
}

}  // namespace muster
