#pragma once

#include "core/play/scene/PlayMortar.h"
#include "editor/background/Derived.h"

namespace rubble {

/// What the mortars of a document join.
class MortarWatch : public Derived<std::vector<JoinedMortar>> {
public:
    MortarWatch(const Document& document, const Bakes& bakes, QObject* parent = nullptr);

    /// The last joints of a mortar; they may be slightly outdated. Null: not known yet.
    const JoinedMortar* find(Id mortar) const;
};

}  // namespace rubble
