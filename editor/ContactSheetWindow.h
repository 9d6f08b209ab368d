#pragma once

#include "editor/play/SheetMaker.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace rubble {

class MainWindow;
class SheetVariety;

/// Variants of one asset side by side, drawn as they are baked: at rest, or under a shot at one step. They are sorted by a measure,
/// chosen, bred again, and one of them is taken for the asset, in one step that can be undone.
class ContactSheetWindow : public QWidget {
    Q_OBJECT
public:
    /// Of the asset at hand.
    explicit ContactSheetWindow(MainWindow& window);

    QListWidget& list() { return *m_list; }
    const SheetMaker& maker() const { return m_maker; }
    /// The variants that are shown, in the list's order, by their numbers.
    std::vector<std::uint32_t> shownNumbers() const;
    const std::vector<LockedSeed>& locked() const { return m_locked; }

    /// Begins anew with the asset as it is.
    void make();
    /// Makes children of the chosen variants.
    void breed();
    /// Holds the seeds that are chosen in the canvas where they are, in all that is made from now on; none: lets go of all.
    void lockChosen();
    /// Takes the pattern of the chosen variant for the asset.
    void use();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    QWidget* makeSettings();
    QWidget* makeBar();
    void fillShots();
    void takeDocument();
    BreedingRecipe recipe() const;
    std::optional<SheetStage> stage() const;
    void begin(Result<std::vector<Asset>> variants);
    void add(const SheetCell& cell);
    void sort();
    void update();
    void say(const QString& sentence);
    const Asset* asset() const;

    MainWindow& m_window;
    Id m_asset;
    SheetMaker m_maker;
    std::vector<SheetCell> m_cells;    // those that are there, in the order they came
    std::vector<LockedSeed> m_locked;  // in all variants
    std::uint64_t m_randomSeed = 1;
    std::size_t m_count = 0;  // of variants that are being made
    SheetVariety* m_variety;
    QSpinBox* m_variants;
    QSpinBox* m_spread;
    QComboBox* m_shot;
    QSpinBox* m_step;
    QComboBox* m_sort;
    QListWidget* m_list;
    QLabel* m_summary;
    QProgressBar* m_progress;
    QPushButton* m_make;
    QPushButton* m_lock;
    QPushButton* m_breed;
    QPushButton* m_use;
    QPushButton* m_cancel;
};

}  // namespace rubble
