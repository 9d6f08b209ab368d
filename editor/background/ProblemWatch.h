#pragma once

#include "editor/background/AssetProblems.h"
#include "editor/background/Derived.h"

namespace rubble {

/// The problems of every asset's last bake, of its strength, and of its instances in the scene.
class ProblemWatch : public Derived<std::map<Id, AssetProblems>> {
public:
    ProblemWatch(const Document& document, const Bakes& bakes, QObject* parent = nullptr);

    /// The problems of an asset; none if it was not checked yet.
    const std::vector<Diagnostic>& of(Id asset) const;
    /// The problems of all assets, in the project's order.
    std::vector<Diagnostic> all() const;
    /// The bake in which an asset's problems were found; null if it could not be baked.
    std::shared_ptr<const Bake> bakeOf(Id asset) const;
};

}  // namespace rubble
