// A shelf of takes in memory.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "muster/session.h"

namespace muster::testing {

/// A take on the shelf.
struct ShelvedTake {
    std::vector<std::uint8_t> bytes;
    bool finished = false;
    bool discarded = false;
};

/// Keeps what a session records, as 1.take, 2.take...
class MemoryShelf {
public:
    /// Lets a session record to it. The shelf must outlive the session.
    void serve(SessionDef& def) {
        def.openSink = [this](const std::string&) -> Result<std::unique_ptr<TakeSink>> {
            const std::string name = std::to_string(takes.size() + 1) + ".take";
            return std::unique_ptr<TakeSink>(new Sink(takes[name], name));
        };
        def.replaceTake = [this](const std::string& name, std::span<const std::uint8_t> bytes) {
            takes[name].bytes.assign(bytes.begin(), bytes.end());
            return Status();
        };
        def.keepAbout = [this](const std::string& name, const TakeAbout& about) {
            edits.emplace_back(name, about);
            return Status();
        };
    }

    std::map<std::string, ShelvedTake> takes;
    std::vector<std::pair<std::string, TakeAbout>> edits;

private:
    class Sink : public TakeSink {
    public:
        Sink(ShelvedTake& take, std::string name) : take_(take), name_(std::move(name)) {}
        Status append(std::span<const std::uint8_t> bytes) override {
            take_.bytes.insert(take_.bytes.end(), bytes.begin(), bytes.end());
            return {};
        }
        Status finish() override {
            take_.finished = true;
            return {};
        }
        Status discard() override {
            take_.discarded = true;
            return {};
        }
        std::string name() const override { return name_; }

    private:
        ShelvedTake& take_;
        std::string name_;
    };
};

}  // namespace muster::testing
