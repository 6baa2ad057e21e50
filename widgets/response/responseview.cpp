// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/response/responseview.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QTableWidget>
#include <QToolButton>

#include "widgets/common/form.h"
#include "widgets/common/look.h"
#include "widgets/common/picture.h"
#include "widgets/common/requests.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/response/responseplot.h"
#include "widgets/response/responsewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

ResponseView::ResponseView(Requests& requests, QWidget* parent)
    : QWidget(parent),
      m_requests(requests),
      m_plot(new ResponsePlot(this)),
      m_readings(new QTableWidget(0, 4, this)),
      m_bar(new QHBoxLayout),
      m_folder(QDir::homePath()) {
    look::name(m_readings, u"responseCursorTable"_s, Common::tr("Cursor readings"));
    m_readings->setHorizontalHeaderLabels(
        {tr("Run"), Common::tr("Cursor 1"), Common::tr("Cursor 2"), Common::tr("Difference")});
    m_readings->verticalHeader()->hide();
    m_readings->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_readings->setSelectionMode(QAbstractItemView::NoSelection);
    m_readings->setFocusPolicy(Qt::NoFocus);
    m_readings->setFont(look::tabular(look::scaled(font(), 0.9)));
    m_readings->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_readings->verticalHeader()->setDefaultSectionSize(m_readings->fontMetrics().height() * 3 / 2);
    m_readings->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_readings->hide();
    m_bar->addStretch(1);
    auto* fit = newButton(u"responseFitButton"_s, tr("Fit"),
                          tr("Fits the view to the motion and all positions (A, in the plot)."));
    auto* measure = newButton(u"responseCursorsButton"_s, Common::tr("Cursors"),
                              tr("Shows two cursors to measure with: drag them (C, in the plot)."));
    measure->setCheckable(true);
    buildMenu();
    form::fill(this, form::newColumn(this, {m_bar, {m_plot, 1}, m_readings}, 0.5));
    connect(fit, &QToolButton::clicked, m_plot, &ResponsePlot::fitAgain);
    connect(measure, &QToolButton::toggled, this, &ResponseView::showCursors);
    connect(m_plot, &ResponsePlot::cursorsWanted, measure, &QToolButton::toggle);
    connect(m_plot, &ResponsePlot::measured, this, &ResponseView::showReadings);
}

QToolButton* ResponseView::newButton(const QString& objectName, const QString& text, const QString& meaning) {
    auto* button = new QToolButton(this);
    look::name(button, objectName, text);
    button->setText(text);
    button->setToolTip(meaning);
    m_bar->addWidget(button);
    return button;
}

void ResponseView::addControl(QWidget* control) {
    m_bar->insertWidget(0, control);
}

void ResponseView::buildMenu() {
    auto* menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    look::name(menu, u"responsePictureMenu"_s, tr("Picture"));
    const auto add = [this, menu](const QString& objectName, const QString& text, const QString& meaning,
                                  const std::function<void()>& act) {
        QAction* action = menu->addAction(text);
        action->setObjectName(objectName);
        action->setToolTip(meaning);
        connect(action, &QAction::triggered, this, act);
    };
    add(u"responsePngAction"_s, Common::tr("&Picture (PNG)…"), Common::tr("The visible plot as an image."),
        [this] { choose(u"png"_s); });
    add(u"responseSvgAction"_s, Common::tr("&Vector picture (SVG)…"),
        Common::tr("The visible plot as lines that stay sharp at any size."), [this] { choose(u"svg"_s); });
    add(u"responsePdfAction"_s, Common::tr("P&age (PDF)…"),
        Common::tr("The visible plot on a page for printing or a report."), [this] { choose(u"pdf"_s); });
    menu->addSeparator();
    add(u"responsePrintAction"_s, Common::tr("P&rint…"),
        Common::tr("Prints the visible plot on one of this computer's printers."),
        [this] { emit m_requests.print(pdfOf(picture())); });
    add(u"responseCopyAction"_s, Common::tr("&Copy picture"), tr("Copies the visible plot to the clipboard."),
        [this] { copy(); });
    QToolButton* button = newButton(u"responsePictureButton"_s, tr("Picture"),
                                    tr("Exports the visible plot, with a description of the runs."));
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
}

void ResponseView::showRuns(const KeptResponse* a, const KeptResponse* b,
                            const std::vector<const KeptResponse*>& others) {
    m_shown.clear();
    for (const KeptResponse* kept : {a, b}) {
        if (kept == nullptr)
            continue;
        const servo::SetGain& gains = kept->run.taken.gains;
        const ResponseMetrics& metrics = kept->run.metrics;
        QString words = (kept == a ? tr("A: run %1, %2, %3, %4") : tr("B: run %1, %2, %3, %4"))
                            .arg(QString::number(kept->number), QString::fromStdString(kept->moduleName),
                                 QString::fromStdString(kept->startedAt),
                                 texts::portName(QString::fromStdString(kept->port)));
        if (kept->simulated)
            words += u" · "_s + Common::tr("SIMULATOR, no real motor moved");
        for (const std::string* own : {&kept->name, &kept->note})
            if (!own->empty())
                words += u" · "_s + QString::fromStdString(*own);
        m_shown << words
                << tr("Kp %1 Kd %2 Ki %3 IL %4; rise %5; overshoot %6; settling %7")
                       .arg(QString::number(gains.kp), QString::number(gains.kd), QString::number(gains.ki),
                            QString::number(gains.il), texts::responseTime(metrics.rise),
                            texts::responseOvershoot(metrics.overshoot), texts::responseSettling(kept->run));
    }
    m_plot->showRuns(a, b, others);
}

// ---- cursors ----

void ResponseView::showCursors(bool shown) {
    m_plot->showCursors(shown);
    m_readings->setVisible(shown);
}

void ResponseView::showReadings() {
    const auto rows = m_plot->readings();
    m_readings->setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < m_readings->rowCount(); ++row)
        for (int column = 0; column < m_readings->columnCount(); ++column) {
            if (m_readings->item(row, column) == nullptr)
                m_readings->setItem(row, column, new QTableWidgetItem);
            QTableWidgetItem* cell = m_readings->item(row, column);
            cell->setText(rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)]);
            if (column > 0)
                cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        }
    m_readings->setFixedHeight(m_readings->horizontalHeader()->sizeHint().height() +
                               m_readings->verticalHeader()->length() + 2 * m_readings->frameWidth());
}

// ---- pictures ----

Picture ResponseView::picture() const {
    QStringList caption{tr("Step response, by NMC Panel %1").arg(QCoreApplication::applicationVersion())};
    caption << m_shown;
    for (const auto& row : m_plot->readings())
        caption << tr("%1: cursor 1 %2, cursor 2 %3, difference %4").arg(row[0], row[1], row[2], row[3]);
    return {m_plot, caption, [this](QPainter& painter) { m_plot->renderTo(painter); }};
}

void ResponseView::choose(const QString& suffix) {
    askWhereToSave(
        this,
        {u"responsePicture%1Dialog"_s.arg(suffix),
         tr("Picture of the step response"),
         {Common::tr("%1 files (*.%2)").arg(suffix.toUpper(), suffix), Common::tr("All files (*)")},
         m_folder,
         tr("step")},
        [this, suffix](const QString& path) {
            m_folder = QFileInfo(path).absolutePath();
            emit m_requests.save(path, fileOf(picture(), suffix));
        });
}

void ResponseView::copy() {
    QGuiApplication::clipboard()->setImage(imageOf(picture()));
}

}  // namespace nmc
