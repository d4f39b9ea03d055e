"""One engine against another: every shape of every case is run by both in turns, and their costs are divided."""

import copy
import statistics

COLUMNS = ("case", "shape", "ns per particle and step", "by the other engine", "ratio", "lowest", "highest")


def report(bench, chosen, other, repeats):
    """Markdown table of what the shapes of the chosen groups cost over what they cost with the engine `other`.

    Both start from the same states, made by the first engine. The order of the two changes from repeat to repeat; a
    ratio is that of two runs beside each other, and the table has the median of the ratios.
    """
    beside = copy.copy(bench)
    beside.engine = other
    lines = ["| " + " | ".join(COLUMNS) + " |", "|" + "---|" * len(COLUMNS)]
    for group in chosen:
        for shape in group.shapes:
            pairs = [pair_of_costs(bench, beside, group, shape, repeat % 2 == 1) for repeat in range(repeats)]
            ratios = [one / two for one, two in pairs]
            one, two = (statistics.median(costs) for costs in zip(*pairs))
            lines.append(f"| {group.name} | {shape.name} | {one:.0f} | {two:.0f} | {statistics.median(ratios):.3f} | "
                         f"{min(ratios):.3f} | {max(ratios):.3f} |")
            print(lines[-1], flush=True)
    return "\n".join(lines)


def pair_of_costs(bench, beside, group, shape, other_first):
    """Costs of one run by each engine (ns per particle and step)."""
    if other_first:
        two = beside.sample(group, shape).cost
        return bench.sample(group, shape).cost, two
    return bench.sample(group, shape).cost, beside.sample(group, shape).cost
