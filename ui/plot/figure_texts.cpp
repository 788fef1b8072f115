// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of a figure: caption, names on axes, words beside points, levels and zones.
#include <algorithm>

#include "ui/plot/figure_frame.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_text.h"

namespace drillwave {
namespace {

const QString betweenParts = QStringLiteral(" · ");  // parts of a caption

/// The last panel of a row.
std::size_t lastOfRow(const StudyFigure& figure, std::size_t row) {
    std::size_t last = 0;
    for (std::size_t i = 0; i < figure.panels.size(); ++i)
        if (figure.panels[i].row == row) last = i;
    return last;
}

/// Maximum number of names beside each other below an axis; more are upright.
constexpr std::size_t mostNamesAbreast = 8;

}  // namespace

QString inLines(const QString& name, std::size_t count) {
    constexpr std::size_t lettersAbreast = 60, leastLetters = 8;
    const std::size_t most =
        count > mostNamesAbreast ? 2 * leastLetters : std::max(leastLetters, lettersAbreast / count);
    QStringList lines;
    for (const QString& word : name.split(QLatin1Char(' '))) {
        if (!lines.isEmpty() && std::size_t(lines.last().size() + 1 + word.size()) <= most)
            lines.last() += QLatin1Char(' ') + word;
        else
            lines << word;
    }
    return lines.join(QLatin1Char('\n'));
}

QString FigureFrame::titleOf(const FigureAxis& axis) const {
    const auto* parameter = std::get_if<KeptParameter>(&axis.quantity);
    return parameter && axis.title.isEmpty() ? parameterTitle(**parameter) : translated(axis.title);
}

void FigureFrame::showLevels() {
    const std::vector<FigureLevel>& levels = m_shown.figure.levels;
    for (Panel& panel : m_panels)
        while (panel.levels.size() < levels.size())
            panel.levels.push_back(addLevel(panel.rect, QStringLiteral("grid")));
    while (m_levelNames.size() < levels.size()) {
        const std::size_t last = lastOfRow(m_shown.figure, levels[m_levelNames.size()].row);
        QCPItemText* name =
            addText(m_panels[last].rect, QMargins(4, 1, 4, 1), Qt::AlignRight | Qt::AlignVCenter);
        name->setLayer(QStringLiteral("legend"));  // above the curves
        setAcross(*name->position);
        name->setFont(m_style.font);
        name->setColor(m_style.text);
        m_levelNames.push_back(name);
    }
    for (std::size_t i = 0; i < m_levelNames.size(); ++i) {
        const bool isShown = i < levels.size() && !m_isCleared;
        for (std::size_t k = 0; k < m_panels.size(); ++k) {
            const bool isThere = isShown && panelOf(k).row == levels[i].row;
            setLevel(*m_panels[k].levels[i],
                     isThere ? std::optional(levels[i].y * yFactorOf(k)) : std::nullopt);
        }
        m_levelNames[i]->setVisible(isShown && !levels[i].name.isEmpty());
        if (!isShown) continue;
        m_levelNames[i]->setText(translated(levels[i].name));
        m_levelNames[i]->position->setCoords(
            1, levels[i].y * yFactorOf(lastOfRow(m_shown.figure, levels[i].row)));
    }
}

// As the plot writes it, which in files is another way.
QString FigureFrame::numberOf(const FigureNumber& number) const {
    if (!number.words.isEmpty()) return translated(number.words);
    if (number.quantity == FigureQuantity(PlainNumber::magnitude))
        return magnitudeText(number.value, m_plot->locale());
    if (number.quantity == FigureQuantity(PlainNumber::runTime))
        return runTimeText(number.value, m_plot->locale());
    const ShownUnit unit = m_shown.units.of(number.quantity);
    const QString value = numberText(number.value * unit.factor, number.digits, m_plot->locale());
    return unit.unit.isEmpty() ? value : value + QChar(QChar::Nbsp) + unit.unit;
}

QString FigureFrame::textOf(const FigureText& text) const {
    QString words = translated(text.pattern);
    for (std::size_t i = 0; i < text.numbers.size(); ++i)
        words.replace(QLatin1Char('%') + QString::number(i + 1), numberOf(text.numbers[i]));
    return words;
}

void FigureFrame::showTexts() {
    if (isEmpty()) return;
    const auto joined = [this](const std::vector<FigureText>& texts) {
        QStringList parts;
        for (const FigureText& text : texts) parts << textOf(text);
        return parts.join(betweenParts);
    };
    m_captionText = joined(m_shown.figure.caption);
    m_caption->setText(m_captionText);
    m_caption->setVisible(!m_captionText.isEmpty());
    // Without words it takes no room.
    auto* header = qobject_cast<QCPLayoutGrid*>(m_legend->layout());
    if (m_captionText.isEmpty() && m_caption->layout()) header->take(m_caption);
    if (!m_captionText.isEmpty() && !m_caption->layout()) header->addElement(1, 0, m_caption);
    m_summary = m_shown.figure.summary.empty() ? m_captionText : joined(m_shown.figure.summary);
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const StudyPanel& panel = panelOf(i);
        for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) {
            const bool isX = side == QCPAxis::atBottom;
            const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
            for (const FigureText& name : isX ? panel.x.names : panel.y.names)
                names->addTick(double(names->ticks().size()),
                               isX ? inLines(textOf(name), panel.x.names.size()) : textOf(name));
            axisOf(i, side)->grid()->setVisible(!panel.field && (isX || names->ticks().isEmpty()));
            if (!names->ticks().isEmpty()) axisOf(i, side)->setTicker(names);
        }
        axisOf(i, QCPAxis::atBottom)->setTickLabelRotation(panel.x.names.size() > mostNamesAbreast ? -90 : 0);
        if (!panel.top) axisOf(i, QCPAxis::atTop)->setLabel(textOf(panel.title));
        for (std::size_t each = 0; each < panel.series.size(); ++each) {
            const FigureSeries& series = panel.series[each];
            const std::vector<QCPItemText*>& texts = m_panels[i].series[each].texts;
            for (std::size_t point = 0; point < texts.size(); ++point) {
                const bool isShown = point < series.texts.size() && point < series.x.size();
                texts[point]->setText(isShown ? textOf(series.texts[point]) : QString());
                texts[point]->setBrush(panel.field ? m_style.behindWords() : QBrush());
                if (isShown)
                    texts[point]->position->setCoords(series.x[point] * xFactorOf(i),
                                                      series.y[point] * yFactorOf(i));
            }
        }
    }
}

// On the other side of its point where a text would end beyond the axes.
void FigureFrame::placeTexts() {
    constexpr auto above = Qt::AlignLeft | Qt::AlignBottom, below = Qt::AlignRight | Qt::AlignTop;
    for (std::size_t i = 0; i < m_panels.size(); ++i)
        for (std::size_t each = 0; each < panelOf(i).series.size(); ++each)
            for (QCPItemText* text : m_panels[i].series[each].texts) {
                const double at = text->position->pixelPosition().x();
                const double before = at - m_panels[i].rect->left(), behind = m_panels[i].rect->right() - at;
                const double width = QFontMetricsF(text->font()).horizontalAdvance(text->text()) +
                                     text->padding().left() + text->padding().right();
                const TextSide side = panelOf(i).series[each].textSide;
                const bool isAbove = side == TextSide::below ? width > before && behind > before
                                                             : width < behind || behind > before;
                text->setPositionAlignment(side == TextSide::over ? Qt::AlignCenter
                                           : isAbove              ? above
                                                                  : below);
            }
}

// As many parts in a line as there is room for; a part that is too long for a line is broken between words.
void FigureFrame::breakCaption() {
    const double room = m_plot->viewport().width() - 20;
    const auto fits = [&, metrics = QFontMetricsF(m_caption->font())](const QString& text) {
        return metrics.horizontalAdvance(text) <= room;
    };
    QStringList lines;
    for (const QString& part : m_captionText.split(betweenParts))
        if (!lines.isEmpty() && fits(lines.last() + betweenParts + part))
            lines.last() += betweenParts + part;
        else
            lines << part;
    for (int i = 0; i < lines.size(); ++i)
        for (qsizetype end = lines[i].size(); !fits(lines[i]) && end > 0;) {
            end = lines[i].lastIndexOf(QLatin1Char(' '), end - 1);
            if (end <= 0 || !fits(lines[i].left(end))) continue;
            lines.insert(i + 1, lines[i].mid(end + 1));
            lines[i].truncate(end);
        }
    m_caption->setText(lines.join(QLatin1Char('\n')));
}

// As far as they are in view: files do not clip.
void FigureFrame::placeZones() {
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        if (!m_isCleared) m_panels[i].bands.place();
        const QCPRange range = axisOf(i, QCPAxis::atLeft)->range();
        const std::optional<FigureZone>& zone = panelOf(i).zone;
        const double from = zone ? zone->from * yFactorOf(i) : 0;
        const bool isShown = !m_isCleared && zone && range.upper > from;
        m_panels[i].zone->setVisible(isShown);
        m_panels[i].zoneName->setVisible(isShown);
        if (!isShown) continue;
        m_panels[i].zone->topLeft->setCoords(0, range.upper);
        m_panels[i].zone->bottomRight->setCoords(1, std::max(from, range.lower));
        m_panels[i].zoneName->setText(translated(zone->name));
    }
}

}  // namespace drillwave
