# SPDX-License-Identifier: Apache-2.0
"""Pictures of the results, as SVG."""
import math

from .tables import median, ratio


def bars(results, o):
    """Bars of tracing time relative to glint's, one group per scene, on a logarithmic scale."""
    programs = [p for p in o.programs if p.name != 'glint']
    bar, left, width = 14, 90, 620
    values = {(s, p.name): ratio(results[s, p.name], results[s, 'glint'])[0] for s in o.scenes for p in programs}
    low, high = min(0.5, *values.values()), max(20, *values.values())

    def place(v):
        return left + (math.log(v) - math.log(low)) / (math.log(high) - math.log(low)) * (width - left - 60)

    colors = ('#4477aa', '#ee6677', '#228833', '#ccbb44', '#66ccee')
    height = len(o.scenes) * (len(programs) + 1) * bar + 60
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" '
           f'font-size="11"><rect width="100%" height="100%" fill="white"/>']
    for i, p in enumerate(programs):
        out.append(f'<rect x="{left + i * 110}" y="8" width="10" height="10" fill="{colors[i % 5]}"/>'
                   f'<text x="{left + i * 110 + 14}" y="17">{p.name}</text>')
    y = 30
    for scene in o.scenes:
        out.append(f'<text x="{left - 8}" y="{y + len(programs) * bar / 2 + 4}" text-anchor="end">{scene}</text>')
        for i, p in enumerate(programs):
            v, x0 = values[scene, p.name], place(1)
            x, w = min(x0, place(v)), abs(place(v) - x0)
            out.append(f'<rect x="{x:.1f}" y="{y}" width="{w:.1f}" height="{bar - 2}" fill="{colors[i % 5]}"/>'
                       f'<text x="{max(place(v), x0) + 4:.1f}" y="{y + 10}">{v:.2f}</text>')
            y += bar
        y += bar
    out.append(f'<line x1="{place(1):.1f}" y1="26" x2="{place(1):.1f}" y2="{y}" stroke="black"/>'
               f'<text x="{place(1):.1f}" y="{y + 14}" text-anchor="middle">1: as long as glint</text></svg>')
    return '\n'.join(out) + '\n'


def growth(results, counts, o):
    """Seconds of loading, building and tracing over the number of spheres, both logarithmic."""
    width, height, left, top, right, bottom = 620, 380, 60, 20, 110, 40
    keys = (('load', '#228833'), ('prepare', '#4477aa'), ('trace', '#ee6677'))
    points = {k: [(counts[s], median(results[s, 'glint'], k)) for s in o.scenes] for k, _ in keys}
    values = [y for line in points.values() for _, y in line]
    x_range = [math.log10(v) for v in (min(counts.values()), max(counts.values()))]
    y_range = [math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))]

    def place(v, span, start, end):
        return start + (math.log10(v) - span[0]) / max(span[1] - span[0], 1e-9) * (end - start)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" '
           f'font-size="11"><rect width="100%" height="100%" fill="white"/>']
    for power in range(y_range[0], y_range[1] + 1):
        y = place(10.0 ** power, y_range, height - bottom, top)
        out.append(f'<line x1="{left}" y1="{y:.1f}" x2="{width - right}" y2="{y:.1f}" stroke="#cccccc"/>'
                   f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{10.0 ** power:g} s</text>')
    for n in counts.values():
        x = place(n, x_range, left, width - right)
        out.append(f'<text x="{x:.1f}" y="{height - bottom + 18}" text-anchor="middle">{n:,}</text>')
    for key, color in keys:
        line = [(place(n, x_range, left, width - right), place(v, y_range, height - bottom, top)) for n, v in points[key]]
        out.append(f'<polyline fill="none" stroke="{color}" stroke-width="2" points="'
                   + ' '.join(f'{x:.1f},{y:.1f}' for x, y in line) + '"/>')
        out.append(f'<text x="{line[-1][0] + 8:.1f}" y="{line[-1][1] + 4:.1f}" fill="{color}">'
                   f'{dict(load="loading", prepare="building", trace="tracing")[key]}</text>')
    out.append(f'<text x="{left}" y="{height - 6}">spheres</text></svg>')
    return '\n'.join(out) + '\n'
