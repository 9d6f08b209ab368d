#pragma once

#include "editor/document/Selection.h"
#include "editor/panels/inspector/HeightStrengthEditor.h"
#include "editor/widgets/Form.h"
#include "editor/widgets/Section.h"

#include <array>

class QLabel;
class QPushButton;

namespace rubble {

class PictureField;

/// How the bonds between the fragments of the active asset hold and break. Hidden while it breaks whole.
class BondSection : public Section {
    Q_OBJECT
public:
    BondSection(Document& document, const Selection& selection, QWidget* parent = nullptr);

    void setUnits(const Units& units);
    void refresh();

signals:
    void refused(const QString& sentence);

private:
    /// The strokes of one brush: their number, and a button that removes them.
    struct StrokeRow {
        BondBrush brush;
        QLabel* count;
        QPushButton* clear;
    };

    std::vector<Asset> selected() const;
    const Material& materialOf(const Asset& asset) const;
    /// Binds a control to a number of the bonds.
    template <class Control, class Number>
    void bindNumber(Control* control, const QString& text, Number Bonding::*member);
    void buildImpulse();
    void buildHits();
    void buildSupport();
    void buildPicture();
    SliderField* addPictureFactor(const QString& label, const QString& hint, const QString& text,
                                  double StrengthImage::*member);
    void pushPicture(const QString& text, const std::shared_ptr<const GreyImage>& picture);
    void addStrokeRow(BondBrush brush, const QString& label, const QString& hint, const QString& text);
    void showImpulse(const Asset& asset);
    void showPicture(const Asset& asset);
    void showStrokes(const Asset& asset);

    Document& m_document;
    const Selection& m_selection;
    Units m_units;
    Form<Asset> m_form;
    QLabel* m_cutNote;
    SliderField* m_impulse = nullptr;
    QLabel* m_derivation = nullptr;  // of the derived impulse, or why there is none
    SliderField* m_radius = nullptr;
    NumberField* m_span = nullptr;
    HeightStrengthEditor* m_heights = nullptr;
    PictureField* m_picture = nullptr;
    std::array<SliderField*, 2> m_pictureFactors{};  // where it is black, where it is white
    std::vector<StrokeRow> m_strokes;
};

}  // namespace rubble
