#include "editor/background/MortarWatch.h"

#include "core/play/scene/PlayScene.h"

#include <algorithm>

namespace rubble {

MortarWatch::MortarWatch(const Document& document, const Bakes& bakes, QObject* parent)
    : Derived(
          {document, {Part::Mortar, Part::Instance, Part::Asset, Part::Scene}, "finding the joints of mortar", &bakes},
          [this, &bakes]() -> Result<Work> {
              const bool hasNone = project().mortars.empty() && value().empty();
              if (hasNone || !bakes.areCurrent(project())) return Work();
              return Work([project = project(), all = bakes.assetBakes()](
                              const TaskContext& task, const Publish&) -> Result<std::vector<JoinedMortar>> {
                  if (project.mortars.empty()) return std::vector<JoinedMortar>();
                  const auto scene = playScene(project, all, task, FindContacts::OnBreak);
                  if (!scene) return scene.error();
                  return (*scene)->mortars;
              });
          },
          parent) {}

const JoinedMortar* MortarWatch::find(Id mortar) const {
    const auto found = std::ranges::find(value(), mortar, &JoinedMortar::mortar);
    return found != value().end() ? &*found : nullptr;
}

}  // namespace rubble
