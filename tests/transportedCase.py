"""Cases of interEvapDemFoam with a surface that the flow carries: the drop of an EvaporationCase, on a wall without
friction.
"""
from evaporationCase import EvaporationCase


class TransportedCase(EvaporationCase):
    def __init__(self, path, sigma=0.0, **keywords):
        super().__init__(path, **{'theta': 90, **keywords})
        self.sigma = sigma
        self.U = (0, 0, 0)
        self.correctors = 3
        self.gravity = (0, 0, 0)

    def write(self):
        motion, self.motion = self.motion, {'type': 'isoAdvector'}
        self.field_file('U', '[0 1 -1 0 0 0 0]', self.U, {'type': 'slip'},
                        {'type': 'pressureInletOutletVelocity', 'value': 'uniform (0 0 0)'}, 'volVectorField')
        self.field_file('p_rgh', '[1 -1 -2 0 0 0 0]', 0, {'type': 'fixedFluxPressure', 'value': 'uniform 0'},
                        {'type': 'fixedValue', 'value': 'uniform 0'})
        super().write()
        self.write_dict('constant/surfaceProperties', {
            'liquid': 'liquid', 'surfaceMotion': self.motion, 'surfaceTension': {'sigma': self.sigma},
            'contactAngles': {'substrate': {'type': 'constant', 'theta': float(self.theta)}}})
        self.motion = motion
        self.write_dict('constant/turbulenceProperties', {'simulationType': 'laminar'})
        symmetric = {'solver': 'PCG', 'preconditioner': 'DIC', 'tolerance': self.tolerance, 'relTol': 0, 'maxIter': 5000}
        other = {'solver': 'PBiCG', 'preconditioner': 'DILU', 'tolerance': self.tolerance, 'relTol': 0}
        self.write_dict('system/fvSolution', {
            'solvers': {'"(chi|extension|p_rgh).*"': symmetric, '"(Y.*|T|U).*"': other,
                        '"alpha.*"': {'nLimiterIter': 3}},
            'PIMPLE': {'momentumPredictor': True, 'nOuterCorrectors': 1, 'nCorrectors': self.correctors},
            'gas': {'nCorrectors': 30, 'tolerance': 1e-10}})
        self.write_dict('system/fvSchemes', {
            'ddtSchemes': {'default': 'Euler'}, 'gradSchemes': {'default': 'Gauss linear'},
            'divSchemes': {'default': 'none', 'div(rhoPhi,U)': 'Gauss upwind', '"div\\(\\(\\(\\(?alphacRho.*"': 'Gauss linear'},
            'laplacianSchemes': {'default': 'Gauss linear corrected'},
            'interpolationSchemes': {'default': 'linear'}, 'snGradSchemes': {'default': 'corrected'}})
        self.write_dict('system/setLiquidDict', {'liquid': 'liquid', 'shapes': {'drop': {
            'type': 'sphericalCap', 'base': (0, 0, 0), 'normal': (0, 0, 1), 'contactRadius': self.a,
            'contactAngle': float(self.theta)}}})

    def prepare(self):
        self.mesh()
        self._must('setLiquid')
