# SPDX-License-Identifier: Apache-2.0
"""Medians, ratios and tables."""
import math
import statistics


def median(rounds, key):
    values = [r[key] for r in rounds if r.get(key) is not None]
    return statistics.median(values) if values else None


def ratio(rounds, ours):
    """The ratio of the median tracing times to glint's, and the least and greatest ratio of a round."""
    each = [a['trace'] / b['trace'] for a, b in zip(rounds, ours)]
    return median(rounds, 'trace') / median(ours, 'trace'), min(each), max(each)


def seconds(value):
    """Three significant digits."""
    if value is None:
        return ''
    return f'{value:.{max(0, 2 - math.floor(math.log10(value)))}f}' if value > 0 else '0'


HEADER = ('scene', 'program', 'tracing s', 'least', 'greatest', 'process s', 'peak MB', 'M rays', 'x glint', 'spread')


def comparison(results, o):
    """The lines of the comparison, headings first."""
    lines = [list(HEADER)]
    for scene in o.scenes:
        ours = results.get((scene, 'glint'))
        for program in o.programs:
            rounds = results[scene, program.name]
            traces = [r['trace'] for r in rounds]
            memory, rays = median(rounds, 'memory'), median(rounds, 'rays')
            row = [scene, program.name, seconds(median(rounds, 'trace')), seconds(min(traces)), seconds(max(traces)),
                   seconds(median(rounds, 'process')), f'{memory / 1e6:.0f}' if memory else '',
                   f'{rays / 1e6:.2f}' if rays else '']
            if ours and program.name != 'glint':
                middle, least, greatest = ratio(rounds, ours)
                row += [f'{middle:.2f}', f'{least:.2f} to {greatest:.2f}']
            lines.append(row + [''] * (len(HEADER) - len(row)))
    return lines


def text_table(lines, words=2):
    """words: the number of leading columns that are words, not numbers."""
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    padded = ([c.ljust(w) if i < words else c.rjust(w) for i, (c, w) in enumerate(zip(line, widths))]
              for line in lines)
    return ''.join('  '.join(line).rstrip() + '\n' for line in padded)


def markdown_table(lines, words=2):
    marks = ['---' if i < words else '---:' for i in range(len(lines[0]))]
    return ''.join('| ' + ' | '.join(line) + ' |\n' for line in [lines[0], marks, *lines[1:]])


def floor_table(results, o):
    """The floor: nanoseconds per ray on one thread, by class."""
    lines = []
    for scene in o.scenes:
        classes = [r['classes'] for r in results.get((scene, 'floor'), [])]
        cells = []
        for name in classes[0] if classes else ():
            rays = classes[0][name]['rays']
            spent = statistics.median(c[name]['seconds'] for c in classes)
            cells.append(f'{name} {spent * o.threads / rays * 1e9:.1f} ns ({rays / 1e6:.2f} M)' if rays else '')
        if cells:
            lines.append(f'  {scene:8} ' + ', '.join(c for c in cells if c) + '\n')
    return 'The floor: nanoseconds of one thread for a ray, and millions of rays\n' + ''.join(lines) if lines else ''


def scale(results, counts, o):
    """The lines of the cost of growing scenes: medians of glint's rounds."""
    lines = [['spheres', 'load s', 'build s', 'tracing s', 'process s', 'peak MB', 'bytes a sphere']]
    for scene in o.scenes:
        rounds = results[scene, 'glint']
        lines.append([f'{counts[scene]:,}', *(seconds(median(rounds, k)) for k in ('load', 'prepare', 'trace', 'process')),
                      f'{median(rounds, "memory") / 1e6:.0f}', f'{median(rounds, "prepared") / counts[scene]:.1f}'])
    return lines


def threads(results, o):
    """The lines of the speedup by threads (medians), and that of a loop in registers."""
    def gain(scene, program):
        one, all_of_them = (results[scene, f'{program}, {n} threads'] for n in (1, o.threads))
        return median(one, 'trace') / median(all_of_them, 'trace')

    lines = [['scene', '1 thread s', f'{o.threads} threads s', 'gain', 'register loop', 'share']]
    for scene in o.scenes:
        ours, loop = gain(scene, 'glint'), gain(scene, 'register loop')
        lines.append([scene, *(seconds(median(results[scene, f'glint, {n} threads'], 'trace')) for n in (1, o.threads)),
                      f'{ours:.2f}', f'{loop:.2f}', f'{ours / loop:.2f}'])
    return lines
