#pragma once

#include "core/asset/AssetDifference.h"
#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"

#include <QThreadPool>

namespace rubble {

/// The asset at hand as it was and as it is now.
struct ComparedAsset {
    bool wasThere = false;               // in the earlier state
    std::vector<RecipeChange> recipe;    // empty where it was not there
    BakeDifference pieces;               // the same
    std::shared_ptr<const Bake> before;  // null where it was not there
    std::shared_ptr<const Bake> after;

    bool isNone() const { return wasThere && recipe.empty() && pieces.isNone(); }
};

/// Compares the asset at hand with what it was in an earlier state of the project, and follows both as they change: the earlier
/// state is baked in the background, once an asset.
class StateComparison : public QObject {
    Q_OBJECT
public:
    StateComparison(const Document& document, const Selection& selection, const Bakes& bakes,
                    QObject* parent = nullptr);
    ~StateComparison() override;

    bool isOn() const { return m_earlier != nullptr; }
    /// What it is compared with: "house.rubble, as it was saved".
    const QString& name() const { return m_name; }
    /// Null where there is no asset at hand, or it is not compared yet.
    const std::shared_ptr<const ComparedAsset>& asset() const { return m_compared; }

    /// Compares with that state from now on.
    void begin(std::shared_ptr<const Project> earlier, const QString& name);
    void end();

signals:
    /// Something else is compared, or what is has other differences.
    void changed();
    void said(const QString& sentence);

private:
    void takeAsset();
    void compare();

    const Document& m_document;
    const Selection& m_selection;
    const Bakes& m_bakes;
    std::shared_ptr<const Project> m_earlier;  // null while nothing is compared
    QString m_name;
    Id m_bakedId = 0;                      // of the asset that m_before is of
    std::shared_ptr<const Bake> m_before;  // of the asset at hand as it was
    std::shared_ptr<const ComparedAsset> m_compared;
    QThreadPool m_thread;
    CancelToken m_cancel;
    int m_run = 0;  // what is of an earlier one comes too late
};

}  // namespace rubble
