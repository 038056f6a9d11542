#include <cstdio>

#include "base/csv_field.h"
#include "base/maths.h"
#include "base/output_file.h"
#include "files/export/formats.h"
#include "files/export/person_facts.h"

namespace muster {
namespace {

class CsvExporter : public Exporter {
public:
    explicit CsvExporter(std::string path) : path_(std::move(path)) {}

    bool wantsPoses() const override { return false; }
    bool wantsClips() const override { return true; }

    Status begin(const ExportInfo& info) override {
        for (const Clip& clip : info.clips->clips) motions_.push_back(csvField(clip.name));
        if (Status s = file_.open(path_); !s.ok()) return s;
        return file_.write("time_s,person,group,group_name,x_m,y_m,heading_deg,speed_m_s,motion,goal\n");
    }

    Status frame(const ExportFrame& frame) override {
        text_.clear();
        PersonFactsReader reader(frame);
        for (const ExportCharacter& c : frame.characters) {
            const PersonFacts facts = reader.of(c.id);
            char line[200];
            std::snprintf(line, sizeof(line), "%.4f,%u,", frame.time, c.id);
            text_ += line;
            // Who has just left has no group any more.
            text_ += facts.group > 0 ? std::to_string(facts.group) + "," + csvField(facts.groupName) : ",";
            std::snprintf(line, sizeof(line), ",%.4f,%.4f,%.2f,%.4f,", c.position.x, c.position.y,
                          static_cast<double>(c.yaw) * 180.0 / kPi, facts.speed);
            text_ += line;
            text_ += motions_[c.clip] + ",";
            if (facts.goal > 0) text_ += std::to_string(facts.goal);
            text_ += '\n';
        }
        return file_.write(text_);
    }

    Status finish() override { return file_.commit(); }

private:
    std::string path_;
    OutputFile file_;
    std::vector<std::string> motions_;  ///< Names of the library's clips.
    std::string text_;
};

}  // namespace

std::unique_ptr<Exporter> makeCsvExporter(const std::string& path) {
    return std::make_unique<CsvExporter>(path);
}

}  // namespace muster
