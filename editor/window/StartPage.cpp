#include "editor/window/StartPage.h"

#include "editor/document/ShownText.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ColourScheme.h"
#include "editor/widgets/Icon.h"
#include "editor/workspace/InstalledData.h"
#include "editor/workspace/RecentFiles.h"

#include <QAbstractButton>
#include <QCommandLinkButton>
#include <QEvent>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

/// Resources of a static library have to be initialised. Q_INIT_RESOURCE does not work inside a namespace.
static void initExamplePictures() { Q_INIT_RESOURCE(examples); }

namespace rubble {

namespace {

constexpr QSize kPictureSize{156, 106};
constexpr const char* kPictureName = "picture";  // a property of the button of an example
constexpr int kMaxRecent = 6;
constexpr int kPageWidth = 1040;        // pixels: six examples side by side
constexpr double kTitleScale = 2.2;     // font size relative to the window's
constexpr double kHeadingScale = 1.15;  // the same

QLabel* heading(const QString& text, double scale) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    font.setBold(true);
    label->setFont(font);
    return label;
}

/// The picture of an example.
QString picture(const QString& example, const QString& theme) {
    return QString(":/examples/%1-%2.png").arg(example, theme);
}

}  // namespace

StartPage::StartPage(RecentFiles& recentFiles, QWidget* parent) : QWidget(parent), m_recentFiles(recentFiles) {
    initExamplePictures();
    auto* columns = new QHBoxLayout;
    columns->addWidget(startColumn(), 1);
    columns->addWidget(recentColumn(), 1);

    auto* page = new QWidget;
    page->setMaximumWidth(kPageWidth);
    auto* rows = new QVBoxLayout(page);
    rows->addWidget(heading(tr("Rubble"), kTitleScale));
    rows->addWidget(new QLabel(tr("Author destructible assets and test how they break.")));
    rows->addSpacing(16);
    rows->addLayout(columns);
    rows->addSpacing(16);
    if (QWidget* examples = exampleRow()) {
        rows->addWidget(heading(tr("Examples"), kHeadingScale));
        rows->addWidget(examples);
    }
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addWidget(page, 10);
    middle->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->addStretch(1);
    layout->addLayout(middle);
    layout->addStretch(2);
    connect(&recentFiles, &RecentFiles::changed, this, &StartPage::fillRecent);
    fillRecent();
}

QWidget* StartPage::startColumn() {
    auto* column = new QWidget;
    auto* rows = new QVBoxLayout(column);
    rows->setContentsMargins({});
    rows->addWidget(heading(tr("Start"), kHeadingScale));
    const auto add = [&](const char* icon, const QString& text, const QString& tip, auto request) {
        auto* button = new QCommandLinkButton(text, tip);
        button->setIcon(iconNamed(icon));
        button->setToolTip(tip);
        button->setAccessibleName(text);
        button->setAccessibleDescription(tip);
        connect(button, &QCommandLinkButton::clicked, this, request);
        rows->addWidget(button);
        return button;
    };
    if (const QString demo = demoProject(); !demo.isEmpty()) {
        const auto request = [this, demo] { emit demoRequested(demo); };
        const QString tip = tr("Open a copy and click in it to break it");
        add("play-start", tr("Play the Demo House"), tip, request)->setObjectName("play-demo");
    }
    add("file-new", tr("New Project"), tr("Create an empty project"), &StartPage::newProjectRequested);
    add("file-open", tr("Open Project"), tr("Open an existing project"), &StartPage::openRequested);
    add("file-import", tr("Import Mesh"), tr("Import an OBJ, glTF, GLB, FBX, STL or PLY file"),
        &StartPage::importRequested);
    rows->addStretch(1);
    return column;
}

QWidget* StartPage::recentColumn() {
    auto* column = new QWidget;
    auto* rows = new QVBoxLayout(column);
    rows->setContentsMargins({});
    rows->addWidget(heading(tr("Recent"), kHeadingScale));
    m_recentRows = new QVBoxLayout;
    rows->addLayout(m_recentRows);
    rows->addStretch(1);
    return column;
}

/// Returns null if no examples are installed. Those without a picture are only found in their folder: there is room for
/// six.
QWidget* StartPage::exampleRow() {
    QStringList paths = exampleProjects();
    paths.removeIf(
        [](const QString& path) { return !QFile::exists(picture(QFileInfo(path).completeBaseName(), "light")); });
    if (paths.isEmpty()) return nullptr;
    auto* row = new QWidget;
    auto* cards = new QHBoxLayout(row);
    cards->setContentsMargins(0, 0, 0, 0);
    for (const QString& path : paths) {
        auto* card = new QToolButton;
        card->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        card->setAutoRaise(true);
        card->setText(exampleTitle(path));
        card->setToolTip(tr("Open a copy of this example"));
        card->setProperty(kPictureName, QFileInfo(path).completeBaseName());
        card->setIconSize(kPictureSize);
        connect(card, &QToolButton::clicked, this, [this, path] { emit exampleRequested(path); });
        cards->addWidget(card);
        m_examples.append(card);
    }
    cards->addStretch(1);
    showPictures();
    return row;
}

/// Those of the theme.
void StartPage::showPictures() {
    const QString theme = isDark(palette()) ? "dark" : "light";
    for (QToolButton* card : m_examples) card->setIcon(QIcon(picture(card->property(kPictureName).toString(), theme)));
}

/// Return clicks the button with the focus, as in a dialog.
void StartPage::keyPressEvent(QKeyEvent* event) {
    const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    auto* button = qobject_cast<QAbstractButton*>(focusWidget());
    if (!isReturn || !button) return QWidget::keyPressEvent(event);
    button->click();
}

void StartPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) showPictures();
    QWidget::changeEvent(event);
}

void StartPage::fillRecent() {
    while (QLayoutItem* item = m_recentRows->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    const QStringList paths = m_recentFiles.paths().mid(0, kMaxRecent);
    if (paths.isEmpty()) {
        auto* placeholder = new QLabel(tr("Projects that you open or save are listed here."));
        placeholder->setWordWrap(true);
        m_recentRows->addWidget(placeholder);
    }
    for (const QString& path : paths) {
        QToolButton* button =
            panelButton("file-project", menuText(fileNameText(path)), toolTipText(pathText(path)), this);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        connect(button, &QToolButton::clicked, this, [this, path] { emit recentRequested(path); });
        m_recentRows->addWidget(button);
    }
}

}  // namespace rubble

#include "moc_StartPage.cpp"
