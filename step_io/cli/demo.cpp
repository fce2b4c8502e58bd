// placeholder until the next save
