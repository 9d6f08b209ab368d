#include "editor/dialogs/ShapeDialog.h"

#include "editor/widgets/NumberField.h"
#include "editor/widgets/TypedFields.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace rubble {

namespace {

constexpr double kMinLength = 0.001;   // m
constexpr double kMaxLength = 1000.0;  // m
constexpr int kMaxCorners = 256;
constexpr int kMinShapeDialogWidth = 320;  // pixels, so that the title fits

}  // namespace

ShapeDialog::ShapeDialog(const QString& title, const QList<Length>& lengths, const Units& units, QWidget* parent)
    : QDialog(parent), m_form(new QFormLayout) {
    setWindowTitle(title);
    for (const Length& length : lengths) {
        auto* field = new NumberField;
        field->setRange({.min = kMinLength, .max = kMaxLength});
        field->setFormat(units.lengths());
        field->setValue(length.value);
        m_form->addRow(length.label, field);
        m_lengths.append(field);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* add = buttons->addButton(tr("Add"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(m_form);
    layout->addWidget(buttons);
    add->setFocusPolicy(Qt::TabFocus);  // a click leaves the focus in a field, so that its text can be refused
    add->setDefault(true);              // after the button was added to the dialog
    setMinimumWidth(kMinShapeDialogWidth);
    m_lengths.front()->selectAll();
    m_lengths.front()->setFocus();
}

void ShapeDialog::addCorners(int value) {
    m_corners = new NumberField;
    m_corners->setRange(FieldRange::whole(3, kMaxCorners));
    m_corners->setValue(value);
    m_form->insertRow(0, tr("&Corners:"), m_corners);
    setTabOrder(m_corners, m_lengths.front());
    m_corners->selectAll();
    m_corners->setFocus();
}

void ShapeDialog::accept() {
    if (commitFields(*this)) QDialog::accept();
}

double ShapeDialog::length(int index) const { return m_lengths[index]->value(); }

int ShapeDialog::corners() const { return static_cast<int>(m_corners->value()); }

}  // namespace rubble

#include "moc_ShapeDialog.cpp"
