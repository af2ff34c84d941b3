import sys
sys.path.insert(0,'/work/w/h4/docs/experiments/rules')
from rules import *
def prof(s,step,mode='one'):
    g=s.grp; nb=(s.nb>>step)+1
    d=np.zeros((len(s.walks),nb+1)); v=g[:,3]*(g[:,4]/256 if mode=='w' else 1.0)
    np.add.at(d,(g[:,0],g[:,1]>>step),v); np.add.at(d,(g[:,0],np.maximum(g[:,1],g[:,2])//(1<<step)+1),-v)
    return d.cumsum(1).max(1)
for n in ('showroom','campsite'):
    s=Scene(n+'.3500')
    have=lambda w,v: [v+str(p) for p in range(4) if s.get(w,v,p) is not None]
    def put(name,p):
        write(p,'p_%s_%s'%(n,name)); need={w for w in s.windows if s.peak['r'][s.get(w,'W')]>5632}
        print(n,name,'windows',len(p),'four',sum(1 for v in p.values() if v[0][0]=='F'),'H',sum(1 for v in p.values() if v[0][0]=='H'),'V',sum(1 for v in p.values() if v[0][0]=='V'),'missed',sorted(need-set(p)),'extra',sorted(set(p)-need))
    put('ref',rule(s,'w',9733,halves=True))
    def byratio(pk,cap,four,v='H'):
        out={}
        for w in s.windows:
            x=pk[s.get(w,'W')]
            if x<=cap or not have(w,'F'): continue
            out[w]=have(w,'F') if x>four*cap else have(w,v)
        return out
    def fits(pk,cap,only=None):
        out={}
        for w in s.windows:
            if pk[s.get(w,'W')]<=cap or not have(w,'F'): continue
            c=[(max(pk[s.get(w,v,p)] for p in (0,1) if s.get(w,v,p) is not None),v) for v in (only or 'HV')]
            m,v=min(c); out[w]=have(w,v) if m<=cap else have(w,'F')
        return out
    W=s.peak['w']; G=s.peak['g']
    put('wH',fits(W,9733,'H'))
    put('wr17',byratio(W,9733,1.7))
    put('g22h',fits(G,22576))
    put('g22r15',byratio(G,22576,1.5))
    put('g22r13',byratio(G,22576,1.3))
    put('g22four',byratio(G,22576,0))
    g2=prof(s,2); put('g2_31h',fits(g2,31440)); put('g2_31four',byratio(g2,31440,0))
    put('g2_27four',byratio(g2,27000,0))
    w2=prof(s,2,'w'); put('w2_14h',fits(w2,14000))
