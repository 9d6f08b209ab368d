#pragma once

#include "core/asset/project/Ranges.h"
#include "core/play/analysis/ThresholdInterval.h"
#include "editor/background/SwapAuditRunner.h"
#include "editor/document/Selection.h"
#include "editor/widgets/numbers/Units.h"

#include <QWidget>

#include <functional>

class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace rubble {

class IntervalBar;

/// The dock with the strength requirements of the active asset, the interval of thresholds that meet them, and the
/// check of how its break starts.
class StrengthPanel : public QWidget {
    Q_OBJECT
public:
    StrengthPanel(Document& document, Selection& selection, const Bakes& bakes, SwapAuditRunner& audits,
                  QWidget* parent = nullptr);

    void setUnits(const Units& units);

signals:
    void refused(const QString& sentence);
    /// A simulation is to be started with a shot, which plays the event of a requirement on an instance; `tried` is its
    /// id, 0 for an event that brings its own body.
    void trialRequested(const rubble::Shot& shot, rubble::Id tried);

private:
    QWidget* makeRequirements();
    QToolButton* makeAddButton();
    QWidget* makeAudit();
    void refresh();
    void refreshRows(const Asset& asset, const ThresholdInterval* interval);
    void addRow(std::size_t index, const StrengthRequirement& requirement);
    void addOutcomeBox(std::size_t index, RequirementOutcome outcome);
    void addField(int row, int column, std::size_t index, ProjectNumber number, double value,
                  const NumberFormat& format, const QString& name,
                  const std::function<void(StrengthRequirement& changed, double value)>& set);
    void addFigure(const Asset& asset, std::size_t index);
    QString assumption(const Asset& asset, const StrengthRequirement& requirement) const;
    void addPlayButton(const Asset& asset, std::size_t index);
    void addSelectButton(const Asset& asset, std::size_t index);
    void selectLost(std::size_t index);
    void addDeleteButton(std::size_t index);
    void play(std::size_t index);
    double strengthOf(const Asset& asset) const;
    QString shownStrength(const Asset& asset, double strength) const;
    Result<ThresholdInterval> intervalOf(const Asset& asset, const std::shared_ptr<const Bake>& bake) const;
    QString verdict(const Asset& asset, const ThresholdInterval& interval) const;
    void refreshAudit();
    void addRequirement(const StrengthRequirement& requirement);
    void change(const QString& text, const std::function<void(Asset&)>& change);
    void applySuggested();
    void deleteFaultySeed();
    /// The seed of the fastest fragment, if the audit failed and the fragment is of the asset's own pattern.
    std::optional<SeedId> faultySeed() const;
    const Asset* asset() const;
    Id selectedInstance() const;

    Document& m_document;
    Selection& m_selection;
    const Bakes& m_bakes;
    SwapAuditRunner& m_audits;
    QLabel* m_title;
    QWidget* m_rows = nullptr;
    QGridLayout* m_grid = nullptr;
    IntervalBar* m_bar;
    QLabel* m_verdict;
    QPushButton* m_apply = nullptr;
    QPushButton* m_audit = nullptr;
    QPushButton* m_fix = nullptr;
    QLabel* m_auditText;
    std::optional<double> m_suggested;  // N·s
    std::optional<PlayAsset> m_whole;   // of the active asset; none until it is baked
    Units m_units;
    /// The contents of the rows.
    struct Shown {
        Id asset = 0;
        std::vector<StrengthRequirement> requirements;
        std::vector<double> impulses;  // N·s
        double threshold = 0.0;        // N·s
        QStringList assumptions;       // one per requirement
        std::vector<Id> tried;         // the instances that the buttons play on
        Units units;
        bool operator==(const Shown&) const = default;
    };
    Shown m_shown;
};

}  // namespace rubble
