#pragma once

#include "editor/background/ComparedAsset.h"
#include "editor/background/Derived.h"
#include "editor/document/Selection.h"

namespace rubble {

/// The difference of the active asset from an earlier state of the project; null until there is one. Bakes the earlier
/// state once per asset.
class StateComparison : public Derived<std::shared_ptr<const ComparedAsset>> {
public:
    StateComparison(const Document& document, const Selection& selection, const Bakes& bakes,
                    QObject* parent = nullptr);

    bool isOn() const { return m_earlier != nullptr; }
    /// The name of the earlier state: "house.rubble as saved".
    const QString& name() const { return m_name; }

    /// Starts comparing with a state.
    void begin(std::shared_ptr<const Project> earlier, const QString& name);
    void end();

private:
    Result<Work> prepare() const;

    const Selection& m_selection;
    const Bakes& m_bakes;
    std::shared_ptr<const Project> m_earlier;  // null if comparing is off
    QString m_name;
};

}  // namespace rubble
