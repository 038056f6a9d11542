#include "files/export/formats.h"

#include <cstdio>

#include "base/output_file.h"
#include "files/export/person_facts.h"

namespace muster {
namespace {

class PedpyExporter : public Exporter {
public:
    explicit PedpyExporter(std::string path) : path_(std::move(path)) {}

    bool wantsPoses() const override { return false; }

    Status begin(const ExportInfo& info) override {
        if (Status s = file_.open(path_); !s.ok()) return s;
        char head[120];
        std::snprintf(head, sizeof(head),
                      "# framerate: %.9g\n# id frame x/m y/m z/m group heading/rad motion goal\n", info.fps);
        return file_.write(head);
    }

    Status frame(const ExportFrame& frame) override {
        text_.clear();
        char line[192];
        PersonFactsReader reader(frame);
        for (const ExportCharacter& c : frame.characters) {
            const PersonFacts facts = reader.of(c.id);
            const int length = std::snprintf(line, sizeof(line), "%u %zu %.6f %.6f 0 %u %.4f %d %u\n", c.id,
                                             frame.index, c.position.x, c.position.y, facts.group,
                                             static_cast<double>(c.yaw), facts.motion, facts.goal);
            text_.append(line, static_cast<std::size_t>(length));
        }
        return file_.write(text_);
    }

    Status finish() override { return file_.commit(); }

private:
    std::string path_;
    OutputFile file_;
    std::string text_;
};

}  // namespace

std::unique_ptr<Exporter> makePedpyExporter(const std::string& path) {
    return std::make_unique<PedpyExporter>(path);
}

}  // namespace muster
