#include "editor/background/OverlapWatch.h"

namespace rubble {

OverlapWatch::OverlapWatch(const Document& document, Messages& messages, QObject* parent)
    : Derived(
          {document, {Part::Instance, Part::Asset, Part::Scene}, "looking for overlapping instances"},
          [this]() -> Result<Work> {
              return Work([project = project()](const TaskContext&, const Publish&) { return overlapNotes(project); });
          },
          parent) {
    connect(this, &OverlapWatch::changed, &messages, [this, &messages] {
        std::vector<Message> all;
        if (error()) all = {{.severity = Severity::Error, .text = QString::fromStdString(error()->message)}};
        for (const auto& [text, instances] : value())
            all.push_back({Severity::Warning, QString::fromStdString(text), 0, std::nullopt, instances});
        messages.setOfScene(std::move(all));
    });
}

}  // namespace rubble
