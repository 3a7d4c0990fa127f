"""Sweeps: one command, many runs, on any of Hydra's launchers.

The command is planned (`plan`): the sweep gets its name and folder, and jobs their absolute paths.
Each job is done once (`job`), whoever does it and however often the sweep is started; at the end
its runs become one table and one figure (`report`).
"""
