#pragma once

#include "editor/background/ContactSheetGenerator.h"
#include "editor/widgets/numbers/Units.h"

#include <QTimer>
#include <QWidget>

#include <set>

class QComboBox;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace rubble {

class StateField;
class VariationTree;
class Workspace;

/// Variants of one asset side by side, rendered as they are baked: at rest, or at one step of a simulation with a shot.
/// They can be sorted by a measure, crossed over, and one of them applied to the asset as one undo step.
class ContactSheetWindow : public QWidget {
    Q_OBJECT
public:
    /// Shows variants of the active asset.
    ContactSheetWindow(Workspace& workspace, const Units& units, QWidget* parent);

    QListWidget& list() { return *m_list; }
    const ContactSheetGenerator& generator() const { return m_generator; }
    /// Returns the numbers of the variants in the order of the list.
    std::vector<std::uint32_t> shownNumbers() const;
    const std::vector<LockedSeed>& locked() const { return m_locked; }

    /// Replaces all variants by those of the asset as it is.
    void generate();
    /// Replaces all other variants by children of the selected ones.
    void crossOver();
    /// Locks the seeds selected in the canvas, in variants generated from now on; without a selection unlocks all.
    void lockSelected();
    /// Applies the selected variant to the asset; asks first whether merges, splits and own settings of fragments,
    /// which the variant does not have, are kept.
    void apply();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* createSettings();
    QWidget* createBar();
    /// Which merges, splits and own settings of fragments the asset has with a variant.
    enum class FragmentSettings { OfAsset, OfVariant, Cancelled };

    FragmentSettings askForSettings(const Asset& variant);
    void setUpList();
    void connectSignals();
    void connectSettings();
    void fillShots();
    void updateDocument();
    VariantRecipe recipe() const;
    /// Errors: those of loadSavedSession().
    Result<std::optional<SheetStage>> stage() const;
    void start(Result<std::vector<Asset>> variants);
    void refreshLater();
    void refresh();
    void regenerate();
    void showFirst(std::size_t count);
    void add(const SheetCell& cell);
    void sort();
    void updateState();
    void showMessage(const QString& sentence);
    const Asset* asset() const;
    const SheetEntry& entryOf(const QListWidgetItem& item) const;

    Workspace& m_workspace;
    Units m_units;
    Id m_asset;
    ContactSheetGenerator m_generator;
    std::vector<SheetCell> m_cells;    // in the order they were finished
    std::vector<LockedSeed> m_locked;  // in all variants
    std::uint64_t m_randomSeed = 1;
    std::size_t m_count = 0;             // of variants being generated
    std::vector<Asset> m_parents;        // that they are children of; empty: they are variants of the asset
    std::set<std::uint32_t> m_selected;  // variants to be selected when they are generated again
    bool m_isStale = false;              // more than the number of variants has changed
    QTimer m_refresh;                    // after a change of the asset or a setting
    bool m_isApplying = false;
    VariationTree* m_variations;
    QSpinBox* m_variants;
    QSpinBox* m_spread;
    QComboBox* m_shot;
    StateField* m_state;
    QSpinBox* m_step;
    QComboBox* m_sort;
    QListWidget* m_list;
    QLabel* m_summary;
    QProgressBar* m_progress;
    QPushButton* m_reseed;
    QPushButton* m_lock;
    QPushButton* m_crossOver;
    QPushButton* m_apply;
    QPushButton* m_cancel;
};

}  // namespace rubble
