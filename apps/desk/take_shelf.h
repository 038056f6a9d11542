// The shelf: all takes that are kept in one folder.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "muster/session.h"
#include "muster/take.h"

namespace muster {

/// A take on the shelf.
struct ShelvedTake {
    std::string name;      ///< Of its file.
    TakeAbout about;       ///< Title, part and speeds.
    std::string scenario;  ///< Title of the scenario.
    std::uint32_t characters = 0;
    std::uint32_t steps = 0;   ///< Of the whole take.
    double stepTime = 0.0;     ///< [s]
    bool finished = false;     ///< It has its end record: the recording was not cut off.
    bool recording = false;    ///< It is being recorded now.
    bool picture = false;      ///< A picture belongs to it.
    std::int64_t changed = 0;  ///< Time of the last change of its file [s since 1970].
    std::uint64_t bytes = 0;   ///< Of its file.
};

/// Takes as files NAME.take with pictures NAME.png. What is removed lies in the folder `removed` in it. All
/// names that clients give are checked here. Any thread may call.
class TakeShelf {
public:
    /// The folder is made when something is put there.
    explicit TakeShelf(std::string folder) : folder_(std::move(folder)) {}

    static constexpr std::size_t kMostPictureBytes = std::size_t{512} << 10;  ///< Size of a picture.
    static constexpr std::size_t kMostTakeBytes = std::size_t{64} << 20;      ///< Size of a take.

    /// Begins a file for a recording of that scenario, named after it and the time; never overwrites one.
    Result<std::unique_ptr<TakeSink>> record(const std::string& scenario);
    /// All takes, the newest first. Files that are no takes are left out.
    std::vector<ShelvedTake> list();
    /// Their titles, in the same order.
    std::vector<std::string> titles();
    /// Puts a take there, unless the same one is there already, and returns its name. Fails as parseTake()
    /// does.
    Result<std::string> put(std::span<const std::uint8_t> bytes);
    /// The bytes of a take. Fails with NotFound.
    Result<std::string> read(const std::string& name) const;
    /// Where a take lies. Fails with NotFound.
    Result<std::string> pathOf(const std::string& name) const;
    /// Says something else about a take. A record torn by a killed writer is left out. Fails with NotFound,
    /// or with Unsupported while it is recorded.
    /// Where it is not `whole`, camera keys and edits of people stay as they are.
    Status edit(const std::string& name, const TakeAbout& about, bool whole = true);
    /// Puts other bytes in the place of a take. Fails as edit() does.
    Status replace(const std::string& name, std::span<const std::uint8_t> bytes);
    /// Keeps a PNG picture of a take.
    Status putPicture(const std::string& name, std::span<const std::uint8_t> png);
    /// Where the picture lies. Fails with NotFound.
    Result<std::string> pictureOf(const std::string& name) const;
    /// Moves a take away, and back. Fails with NotFound, or with Unsupported while it is recorded.
    Status remove(const std::string& name);
    Status restore(const std::string& name);  ///< As above.

private:
    class Recording;

    std::string path(const std::string& name) const { return folder_ + "/" + name; }
    std::string sameFile(std::span<const std::uint8_t> bytes);
    Status untouched(const std::string& name) const;
    Status move(const std::string& from, const std::string& to, const std::string& name) const;
    void ended(const std::string& name);

    std::string folder_;
    mutable std::mutex mutex_;
    std::set<std::string> recording_;           // Names of files that are being written.
    std::map<std::string, ShelvedTake> known_;  // What list() found, by name.
};

}  // namespace muster
