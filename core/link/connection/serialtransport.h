// SPDX-License-Identifier: MIT
#pragma once

#include <QEventLoop>
#include <QSerialPort>
#include <QString>
#include <functional>

#include "link/connection/transport.h"
#include "link/ports/linerate.h"
#include "protocol/baud.h"

namespace nmc {

/// A serial port through QSerialPort, 8N1, no flow control. Nobody else may use the port meanwhile: besides
/// Qt's lock file, which goes by name, the descriptor is locked with flock, which catches other names for it
/// and root.
class SerialTransport : public Transport {
public:
    /// Tells the rate that a descriptor really has, where it can.
    using RateReader = std::function<std::optional<std::uint32_t>(int)>;

    /// `baud`: the rate that will be wanted later. open() tries whether the adapter can make it, before a
    /// byte has been sent.
    explicit SerialTransport(QString port, std::uint32_t baud = kPowerUpBaud, RateReader realRate = lineRate);
    ~SerialTransport() override;

    tl::expected<void, PortError> open() override;
    tl::expected<void, PortError> setBaud(std::uint32_t baud) override;
    tl::expected<void, PortError> send(ByteSpan bytes) override;
    void discardInput() override;
    tl::expected<std::vector<std::uint8_t>, PortError> receive(std::optional<TimePoint> until,
                                                               int wakeFd) override;
    [[nodiscard]] int fd() const override { return m_port.handle(); }

private:
    [[nodiscard]] PortError openError() const;
    [[nodiscard]] PortError gone() const;
    [[nodiscard]] PortError problem(PortProblem what, const QString& detail) const;

    QString m_name;
    std::uint32_t m_baud;
    RateReader m_realRate;
    /// Never turned: it brings along the event dispatcher that a port insists on, in a thread that is not
    /// Qt's.
    QEventLoop m_dispatcher;
    QSerialPort m_port;
};

}  // namespace nmc
