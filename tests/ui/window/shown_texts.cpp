// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/shown_texts.h"

#include <qcustomplot.h>
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTabBar>
#include <QTextDocumentFragment>

namespace drillwave {
namespace {

/// Takes them in as they are found.
class Texts {
  public:
    void add(const QObject& part, const char* what, const QString& text) {
        if (text.isEmpty()) return;
        const QString plain =
            Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
        const QObject* above = part.parent();
        m_found.append(
            {QStringLiteral("%1 “%2” of %3, %4")
                 .arg(QLatin1String(part.metaObject()->className()), part.objectName(),
                      QLatin1String(above ? above->metaObject()->className() : "none"), QLatin1String(what)),
             plain});
    }
    QList<ShownText> take() { return std::move(m_found); }

  private:
    QList<ShownText> m_found;
};

void addModel(const QAbstractItemView& view, Texts& texts) {
    const QAbstractItemModel* model = view.model();
    if (!model) return;
    constexpr int mostRows = 200;
    for (int column = 0; column < model->columnCount(); ++column)
        for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
            texts.add(view, "column", model->headerData(column, Qt::Horizontal, role).toString());
    for (int row = 0; row < std::min(model->rowCount(), mostRows); ++row) {
        for (const int role : {Qt::DisplayRole, Qt::ToolTipRole}) {
            texts.add(view, "row", model->headerData(row, Qt::Vertical, role).toString());
            for (int column = 0; column < model->columnCount(); ++column)
                texts.add(view, "cell", model->index(row, column).data(role).toString());
        }
    }
}

void addPlot(QCustomPlot& plot, Texts& texts) {
    for (const QCPAxisRect* rect : plot.axisRects())
        for (const QCPAxis* axis : rect->axes()) texts.add(plot, "axis", axis->label());
    // Others have the name that the library gives them, which nobody sees.
    for (QCPLegend* legend : plot.findChildren<QCPLegend*>())
        for (int i = 0; i < legend->itemCount(); ++i)
            if (auto* item = qobject_cast<QCPPlottableLegendItem*>(legend->item(i)))
                texts.add(plot, "curve", item->plottable()->name());
    for (int i = 0; i < plot.itemCount(); ++i)
        if (const auto* text = qobject_cast<const QCPItemText*>(plot.item(i)); text && text->realVisibility())
            texts.add(plot, "item", text->text());
    for (const QCPTextElement* element : plot.findChildren<QCPTextElement*>())
        texts.add(plot, "title", element->text());
}

void addWidget(QWidget& widget, Texts& texts) {
    texts.add(widget, "tool tip", widget.toolTip());
    texts.add(widget, "status tip", widget.statusTip());
    texts.add(widget, "what is this", widget.whatsThis());
    texts.add(widget, "accessible name", widget.accessibleName());
    texts.add(widget, "accessible description", widget.accessibleDescription());
    if (widget.isWindow() || qobject_cast<const QDockWidget*>(&widget))
        texts.add(widget, "window title", widget.windowTitle());
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) texts.add(widget, "text", label->text());
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        texts.add(widget, "text", button->text());
    if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
        texts.add(widget, "title", group->title());
    if (const auto* edit = qobject_cast<const QLineEdit*>(&widget))
        texts.add(widget, "placeholder", edit->placeholderText());
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&widget))
        texts.add(widget, "special value", box->specialValueText());
    if (const auto* box = qobject_cast<const QSpinBox*>(&widget))
        texts.add(widget, "suffix", box->suffix() + box->prefix());
    if (const auto* bar = qobject_cast<const QTabBar*>(&widget))
        for (int tab = 0; tab < bar->count(); ++tab) {
            texts.add(widget, "tab", bar->tabText(tab));
            texts.add(widget, "tab's tip", bar->tabToolTip(tab));
        }
    if (const auto* box = qobject_cast<const QComboBox*>(&widget))
        for (int item = 0; item < box->count(); ++item) {
            texts.add(widget, "item", box->itemText(item));
            texts.add(widget, "item's tip", box->itemData(item, Qt::ToolTipRole).toString());
        }
    else if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget);
             view && !qobject_cast<const QComboBox*>(widget.parentWidget()))
        addModel(*view, texts);
    if (auto* plot = qobject_cast<QCustomPlot*>(&widget)) addPlot(*plot, texts);
}

}  // namespace

QList<ShownText> shownTexts(QWidget& window) {
    Texts texts;
    addWidget(window, texts);
    for (QWidget* widget : window.findChildren<QWidget*>()) addWidget(*widget, texts);
    for (const QAction* action : window.findChildren<QAction*>()) {
        texts.add(*action, "text", action->text());
        texts.add(*action, "tool tip", action->toolTip());
    }
    return texts.take();
}

}  // namespace drillwave
