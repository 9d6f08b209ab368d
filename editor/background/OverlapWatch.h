#pragma once

#include "core/play/scene/InstanceOverlaps.h"
#include "editor/background/Derived.h"
#include "editor/document/Messages.h"

namespace rubble {

/// Instances that overlap each other or the ground. Keeps the messages of the scene up to date.
class OverlapWatch : public Derived<std::vector<OverlapNote>> {
public:
    OverlapWatch(const Document& document, Messages& messages, QObject* parent = nullptr);
};

}  // namespace rubble
