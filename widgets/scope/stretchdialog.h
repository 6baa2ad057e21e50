// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "widgets/scope/scopestretch.h"
#include "widgets/scope/tracebox.h"

namespace nmc {

class ScopeStrips;

/// A window about signals between the cursors. It follows the cursors, and new samples between them, as long
/// as it is open. A derived window adds boxes in which the signals are chosen, and shows their samples. GUI
/// thread.
class StretchDialog : public QDialog {
    Q_OBJECT

public:
    /// Returns false if not everything is up to date yet, which needs another call.
    bool showStretch(const ScopeStrips& strips, const History& history);

signals:
    /// showStretch() must be called soon.
    void frameWanted();

protected:
    /// The samples of the signal that is chosen in a box.
    struct Samples {
        ScopePlot::Trace trace;
        QString unit;
        std::vector<SignalPoint> points;
        bool kept = true;  ///< false: they are no longer kept individually
    };

    StretchDialog(const QString& objectName, const QString& title, QWidget* parent);
    /// Adds a box; the parameters are those of TraceBox.
    TraceBox* newBox(const QString& objectName, const QString& accessible, int first);
    /// The signal whose samples are read for a trace, in the unit of the trace's scale.
    [[nodiscard]] virtual ScopeSignal readsFor(ScopeSignal signal) const { return signal; }
    /// Shows the samples of all boxes, in their order.
    virtual void showSamples(const std::vector<Samples>& samples) = 0;
    /// Why there is nothing to show: the samples are too few, too many (`most`) or not kept; empty if they
    /// are none of that.
    [[nodiscard]] static QString whyNothing(const Samples& samples, std::size_t fewest, std::size_t most);

private:
    /// Returns true: nothing is left to be done.
    bool showNothing();

    std::vector<TraceBox*> m_boxes;
    std::vector<ScopeStretch> m_shown;
    QStringList m_labels;            ///< of the signals that are shown
    std::vector<Samples> m_samples;  ///< kept only so that its memory is used again
    int m_pause = 0;                 ///< calls until the same signals are shown again
};

}  // namespace nmc
