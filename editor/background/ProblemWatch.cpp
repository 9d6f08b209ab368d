#include "editor/background/ProblemWatch.h"

#include "core/play/scene/SupportProblems.h"

namespace rubble {

ProblemWatch::ProblemWatch(const Document& document, const Bakes& bakes, QObject* parent)
    : Derived(
          {document,
           {Part::Asset, Part::Material, Part::Instance, Part::Mortar, Part::Scene},
           "looking for problems",
           &bakes},
          [this, &bakes]() -> Result<Work> {
              if (bakes.all().empty() && value().empty() && !project().assets.empty()) return Work();
              const bool hasScene = mayHaveSceneProblems(project()) && bakes.areCurrent(project());
              return Work(
                  [project = project(), baked = bakes.all(), earlier = value(),
                   sceneBakes = hasScene ? bakes.assetBakes() : AssetBakes()](const TaskContext& task, const Publish&) {
                      return problemsByAsset(project, baked, sceneBakes, earlier, task);
                  });
          },
          parent) {}

const std::vector<Diagnostic>& ProblemWatch::of(Id asset) const {
    static const std::vector<Diagnostic> kNoProblems;
    const auto found = value().find(asset);
    return found == value().end() ? kNoProblems : found->second.all;
}

std::vector<Diagnostic> ProblemWatch::all() const {
    std::vector<Diagnostic> all;
    for (const Asset& asset : project().assets) all.insert(all.end(), of(asset.id).begin(), of(asset.id).end());
    return all;
}

std::shared_ptr<const Bake> ProblemWatch::bakeOf(Id asset) const {
    const auto found = value().find(asset);
    return found == value().end() ? nullptr : found->second.baked->bake;
}

}  // namespace rubble
