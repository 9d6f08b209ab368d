#pragma once

#include "core/play/Intent.h"
#include "editor/document/Selection.h"
#include "editor/play/AssetTrials.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QPushButton;

namespace rubble {

class IntervalBar;

/// The dock with what the asset at hand is to take: sentences, the thresholds that fit them all, and whether its swap for pieces is
/// clean.
class IntentPanel : public QWidget {
    Q_OBJECT
public:
    IntentPanel(Document& document, const Selection& selection, const Bakes& bakes, AssetTrials& trials,
                QWidget* parent = nullptr);

signals:
    void refused(const QString& sentence);

private:
    QWidget* makeIntents();
    QWidget* makeAudit();
    void fill();
    void fillRows(const Asset& asset, const ThresholdInterval* interval);
    void addRow(int row, const Asset& asset, std::size_t index, const ThresholdInterval* interval);
    void showAudit();
    void addIntent(const Intent& intent);
    void change(const QString& text, const std::function<void(Asset&)>& change);
    void useSuggested();
    void deleteFaultySeed();
    /// The seed of the fastest piece of an audit that is not clean, where it is of the asset's own pattern.
    std::optional<SeedId> faultySeed() const;
    const Asset* asset() const;

    Document& m_document;
    const Selection& m_selection;
    const Bakes& m_bakes;
    AssetTrials& m_trials;
    QLabel* m_title;
    QWidget* m_rows = nullptr;
    QGridLayout* m_grid = nullptr;
    IntervalBar* m_bar;
    QLabel* m_verdict;
    QPushButton* m_use = nullptr;
    QPushButton* m_audit = nullptr;
    QPushButton* m_fix = nullptr;
    QLabel* m_auditText;
    std::optional<double> m_suggested;  // N s
    /// What the rows say.
    struct Shown {
        Id asset = 0;
        std::vector<Intent> intents;
        std::vector<double> impulses;  // N s
        bool operator==(const Shown&) const = default;
    };
    Shown m_shown;
};

}  // namespace rubble
