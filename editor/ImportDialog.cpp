#include "editor/ImportDialog.h"

#include "editor/ChoiceBox.h"
#include "editor/ImportView.h"
#include "editor/MeshReading.h"
#include "editor/OutlinePreview.h"
#include "editor/commands/ProjectEdits.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

namespace rubble {

namespace {

enum Column { kName, kSize, kDepth, kAxis, kTolerance, kColumns };

QString text(const std::string& sentence) { return QString::fromStdString(sentence); }

QString sizeText(const FoundPrism& prism) {
    const Vec2 size = boundsOf(prism.outline.outer).size();
    return text(lengthText(size.x) + " × " + lengthText(size.y));
}

}  // namespace

ImportDialog::ImportDialog(const QString& path, const Project& project, const Preferences& preferences, QWidget* parent)
    : QDialog(parent), m_path(path), m_project(project), m_view(new ImportView(preferences)) {
    setWindowTitle(tr("Import %1").arg(QFileInfo(path).fileName()));
    makeFields();
    for (QComboBox* box : {m_unit, m_up}) connect(box, &QComboBox::currentIndexChanged, this, &ImportDialog::showMesh);
    for (QComboBox* box : {m_axis, m_fallback}) {
        connect(box, &QComboBox::currentIndexChanged, this, &ImportDialog::update);
    }
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) { showRow(row); });
}

bool ImportDialog::read(const std::filesystem::path& importer) {
    std::optional<SourceScene> scene = readMesh(m_path, importer, parentWidget());
    if (!scene) return false;
    m_scene = std::move(*scene);
    showMesh();
    return true;
}

Edit ImportDialog::edit() const {
    return editBetween(tr("Import %1").arg(QFileInfo(m_path).fileName()), m_project, m_outcome->project);
}

std::vector<Message> ImportDialog::messages() const {
    std::vector<Message> messages;
    for (const ImportedAsset& found : m_outcome->assets) {
        for (const std::string& note : found.notes) messages.push_back({.text = text(note), .asset = found.asset});
    }
    for (const Error& fault : m_outcome->refused) {
        messages.push_back({.severity = Severity::Fault, .text = text(fault.message)});
    }
    return messages;
}

Id ImportDialog::firstAsset() const { return m_outcome->assets.front().asset; }

void ImportDialog::makeFields() {
    m_found = new QLabel;
    m_found->setWordWrap(true);
    m_unit = unitBox();
    m_up = choiceBox({tr("Y"), tr("Z")}, tr("Which axis of the file points up"));
    m_axis = choiceBox({tr("Where it is thinnest"), tr("X"), tr("Y (up)"), tr("Z")},
                       tr("Along which axis of the world the outline is extruded"));
    m_fallback = choiceBox({tr("Refuse it"), tr("Take its silhouette"), tr("Take its top face")},
                           tr("What to do with an object that is no prism"));
    m_table = new QTableWidget(0, kColumns);
    m_table->setHorizontalHeaderLabels({tr("Asset"), tr("Outline"), tr("Depth"), tr("Axis"), tr("Tolerance")});
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setAccessibleName(tr("Assets found"));
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
    m_preview = new OutlinePreview;
    m_notes = new QLabel;
    m_notes->setWordWrap(true);
    m_notes->setTextFormat(Qt::PlainText);
    m_refused = new QLabel;
    m_refused->setWordWrap(true);
    m_refused->setTextFormat(Qt::PlainText);
    m_refused->hide();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_import = buttons->addButton(tr("Import"), QDialogButtonBox::AcceptRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

    auto* top = new QHBoxLayout;
    top->addWidget(m_view, 1);
    top->addWidget(makeOptions());
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_found);
    layout->addLayout(top, 3);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_notes);
    layout->addWidget(m_refused);
    layout->addWidget(buttons);
    m_import->setDefault(true);  // a button knows its dialog only now
    resize(920, 700);
}

/// How the file is taken, above the outline that follows from it.
QWidget* ImportDialog::makeOptions() {
    auto* options = new QWidget;
    auto* form = new QFormLayout;
    form->addRow(tr("&Unit:"), m_unit);
    form->addRow(tr("U&p:"), m_up);
    form->addRow(tr("&Extrude along:"), m_axis);
    form->addRow(tr("&No prism:"), m_fallback);
    auto* rows = new QVBoxLayout(options);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addLayout(form);
    rows->addWidget(new QLabel(tr("Outline, seen along the axis:")));
    rows->addWidget(m_preview, 1);
    return options;
}

ImportOptions ImportDialog::options() const {
    ImportOptions options{.metresPerUnit = metresOf(*m_unit)};
    options.up = m_up->currentIndex() == 1 ? UpAxis::Z : UpAxis::Y;
    options.axis = static_cast<AxisChoice>(m_axis->currentIndex());
    if (m_fallback->currentIndex() == 1) options.fallback = PrismFallback::Silhouette;
    if (m_fallback->currentIndex() == 2) options.fallback = PrismFallback::TopCap;
    return options;
}

double ImportDialog::metresPerUnit() const {
    const double inFile = m_scene.metresPerUnit > 0.0 ? m_scene.metresPerUnit : 1.0;
    return metresOf(*m_unit).value_or(inFile);
}

void ImportDialog::showMesh() {
    m_view->setModel(sourceModel(m_scene, metresPerUnit(), options().up));
    update();
}

void ImportDialog::update() {
    const Result<ImportOutcome> outcome =
        importedInto(m_project, m_scene, QFileInfo(m_path).completeBaseName().toStdString(), options(), TaskContext{});
    m_outcome.reset();
    if (outcome) m_outcome = *outcome;
    m_import->setEnabled(m_outcome && !m_outcome->assets.empty());
    showFound(outcome);
    fillTable();
}

void ImportDialog::showFound(const Result<ImportOutcome>& outcome) {
    std::size_t triangles = 0;
    for (const SourceObject& object : m_scene.objects) triangles += object.triangles.size();
    const QString unit = m_scene.metresPerUnit > 0.0
                             ? tr("one unit is %1").arg(text(lengthText(m_scene.metresPerUnit)))
                             : tr("it does not say its unit: metres, unless you choose another");
    m_found->setText(
        tr("The file holds %n object(s) of %1 triangles; %2.", nullptr, static_cast<int>(m_scene.objects.size()))
            .arg(triangles)
            .arg(unit));
    QStringList refused;
    if (!outcome) refused.append(text(outcome.error().message));
    if (m_outcome) {
        for (const Error& fault : m_outcome->refused) refused.append(text(fault.message));
    }
    m_refused->setText(refused.isEmpty() ? QString() : tr("Refused:") + '\n' + refused.join('\n'));
    m_refused->setVisible(!refused.isEmpty());
}

void ImportDialog::fillTable() {
    m_table->setRowCount(0);
    m_preview->setOutline({});
    m_view->setPrism(nullptr);
    m_notes->clear();
    if (!m_outcome) return;
    m_table->setRowCount(static_cast<int>(m_outcome->assets.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const ImportedAsset& found = m_outcome->assets[static_cast<std::size_t>(row)];
        const QStringList cells = {text(findAsset(m_outcome->project, found.asset)->name), sizeText(found.prism),
                                   text(lengthText(found.prism.depth)), text(axisText(found.prism.axis)),
                                   text(lengthText(found.tolerance))};
        for (int column = 0; column < kColumns; ++column) {
            m_table->setItem(row, column, new QTableWidgetItem(cells[column]));
        }
    }
    m_table->setCurrentCell(0, kName);
}

void ImportDialog::showRow(int row) {
    if (!m_outcome || row < 0) return;
    const ImportedAsset& found = m_outcome->assets[static_cast<std::size_t>(row)];
    m_preview->setOutline(found.prism.outline);
    m_view->setPrism(&found.prism);
    QStringList notes;
    for (const std::string& note : found.notes) notes.append(text(note));
    if (!found.isStandIn && found.prism.deviation == 0.0) notes.append(tr("The mesh is this prism exactly."));
    if (!found.isStandIn && found.prism.deviation > 0.0) {
        notes.append(tr("The mesh lies within %1 of the prism.").arg(text(lengthText(found.prism.deviation))));
    }
    m_notes->setText(notes.join('\n'));
}

}  // namespace rubble
