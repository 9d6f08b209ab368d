#pragma once

#include "editor/background/ComparedAsset.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"
#include "editor/document/jobs/BackgroundJob.h"

namespace rubble {

/// Compares the active asset with an earlier state of the project, and updates the result as both change. Bakes the
/// earlier state in the background, once per asset.
class StateComparison : public QObject {
    Q_OBJECT
public:
    StateComparison(const Document& document, const Selection& selection, const Bakes& bakes,
                    QObject* parent = nullptr);

    bool isOn() const { return m_earlier != nullptr; }
    /// The name of the earlier state: "house.rubble as saved".
    const QString& name() const { return m_name; }
    /// Null if there is no active asset or no result yet.
    const std::shared_ptr<const ComparedAsset>& asset() const { return m_compared; }

    /// Starts comparing with a state.
    void begin(std::shared_ptr<const Project> earlier, const QString& name);
    void end();

signals:
    /// The earlier state, the asset or the result changed.
    void changed();
    void statusMessage(const QString& sentence);

private:
    void restart();
    void compare();

    const Document& m_document;
    const Selection& m_selection;
    const Bakes& m_bakes;
    std::shared_ptr<const Project> m_earlier;  // null if comparing is off
    QString m_name;
    Id m_bakedId = 0;                      // of the asset of m_before
    std::shared_ptr<const Bake> m_before;  // of the active asset in the earlier state
    std::shared_ptr<const ComparedAsset> m_compared;
    BackgroundJob m_job;
};

}  // namespace rubble
