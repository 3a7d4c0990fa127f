def similarity(rooms, run):
    pass
