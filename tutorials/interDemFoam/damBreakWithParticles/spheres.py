"""Five layers of spheres on the floor of the column of water."""
D, COLUMN, DEPTH = 2.7e-3, 57.15e-3, 11.43e-3
COUNT = (19, 4, 5)


def write(path):
    with open(path, 'w') as out:
        print('x,y,z,d', file=out)
        nx, ny, nz = COUNT
        for k in range(nz):
            for j in range(ny):
                for i in range(nx):
                    # A little off their lattice, so that they do not stand on each other
                    jog = ((5*i + 3*j + 7*k) % 11 - 5)*1e-5
                    x = (i + 0.5)*COLUMN/19 + jog
                    y = (j + 0.5)*DEPTH/4 - jog
                    print(f'{x:.7f},{y:.7f},{D*(k + 0.51) + 2e-5*k:.7f},{D}', file=out)
