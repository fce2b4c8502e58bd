#include "suture/fill/extend/region.h"

namespace suture::extend {
namespace {

using Eigen::Vector2d;

Result<Region> disc(const Chart& chart, const std::vector<Trace>& traces, bool reversed) {
    Region region;
    int enclosing = 0;
    for (std::size_t l = 0; l < traces.size(); ++l) {
        if ((traces[l].area() > 0.0) != reversed) {
            region.outer = static_cast<int>(l);
            ++enclosing;
        }
    }
    if (enclosing == 0) {
        return fail(ErrorCode::Refused, "no loop encloses a part of the {}: all around is missing",
                    kind_name(chart.surface));
    }
    if (enclosing > 1) {
        return fail(ErrorCode::Refused,
                    "{} loops enclose a part of the {} each: they are as many holes", enclosing,
                    kind_name(chart.surface));
    }
    const Trace& outer = traces[static_cast<std::size_t>(region.outer)];
    const Vector2d size = outer.high() - outer.low();
    for (const int c : {0, 1}) {
        if (chart.period[c] > 0.0 && size[c] >= chart.period[c]) {
            return fail(ErrorCode::Refused, "the hole overlaps itself around the axis of the {}",
                        kind_name(chart.surface));
        }
    }
    return region;
}

}  // namespace

Result<Region> region_of(const Chart& chart, const std::vector<Trace>& traces, bool reversed) {
    Region region;
    for (int l = 0; l < static_cast<int>(traces.size()); ++l) {
        const Eigen::Vector2i& winding = traces[static_cast<std::size_t>(l)].winding;
        if (winding.isZero()) {
            continue;
        }
        if (winding.cwiseAbs().sum() != 1) {
            return fail(ErrorCode::Refused,
                        "a loop winds {} times around the {} one way and {} times the other",
                        winding.x(), kind_name(chart.surface), winding.y());
        }
        region.around = winding.x() != 0 ? 0 : 1;
        const int left = region.around == 0 ? winding.x() : -winding.y();
        int& place = (left > 0) != reversed ? region.low : region.high;
        if (place >= 0) {
            return fail(ErrorCode::Refused, "two loops go the same way around the {}",
                        kind_name(chart.surface));
        }
        place = l;
    }
    if (region.low < 0 && region.high < 0) {
        return disc(chart, traces, reversed);
    }
    const int across = 1 - region.around;
    const auto centre = [&](int l) { return traces[static_cast<std::size_t>(l)].centre()[across]; };
    if (region.low >= 0 && region.high >= 0) {
        region.kind = Region::Kind::Band;
        if (traces[static_cast<std::size_t>(region.low)].winding[across] != 0 ||
            traces[static_cast<std::size_t>(region.high)].winding[across] != 0) {
            return fail(ErrorCode::Refused, "two loops cross on the {}", kind_name(chart.surface));
        }
        if (!(chart.period[across] > 0.0) && !(centre(region.low) < centre(region.high))) {
            return fail(ErrorCode::Refused,
                        "the material lies between the two loops: the {} goes on to both sides",
                        kind_name(chart.surface));
        }
        return region;
    }
    region.kind = Region::Kind::Pole;
    const double side = region.low >= 0 ? 1.0 : -1.0;
    const double at = centre(region.low >= 0 ? region.low : region.high);
    for (const Pole& pole : chart.poles) {
        if (pole.across == across && pole.side == side && side * (pole.value - at) > 0.0) {
            region.pole = &pole;
        }
    }
    if (region.pole == nullptr) {
        return fail(ErrorCode::Refused,
                    "the hole goes all the way around the {} and nothing ends it on the other side",
                    kind_name(chart.surface));
    }
    return region;
}

}  // namespace suture::extend
